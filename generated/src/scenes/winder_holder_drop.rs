// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   044e0f4a1f2bab23afeb6e3d262a47321342ed9c5c3cc52995c00ca78c21b7a4  scenes/winder_holder_drop.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//   aa0e8a999f462eeff001756527f878c9e91be49559e9f536983ca628c62c89a6  units/spring_damper.toml
//   3a06aa48a56961be277bb8748bfcb9b7930fe7d6c621790a5198dd36ddd4f5c6  units/one_sided_contact.toml
//
// Four-link bobbin holder, let go
//
// The holder of `winder_linkage` with package and post lifted: it falls until the bobbin meets
// the drum and the post its stop, bounces, and settles at work. Drum and stop only push: both
// contacts are springs and dampers that open and close by events. The drum stands still.
//
// Source:
//   Study of a winding mechanism; dimensions are ours.
//
// All quantities are in SI units.
// Shapes: coordinates 14, first-order states 2, states 30, parameters 5, outputs 7, events 4,
//     constraints 12.
// Nonzeros: mass_matrix 14 of 14 by 14, rate_jacobian 294 of 30 by 30,
//     parameter_jacobian 56 of 30 by 5, constraint_matrix 37 of 12 by 14.
// Operations: initial_state 1, rate 724, forcing 80, rate_jacobian 4788, parameter_jacobian 1069,
//     outputs 52, energy 78, power_balance 820, guards 28, guard_rates 709, constraint_values 49,
//     constraint_rates 63, constraint_matrix 30, prepare 1, prepared_rate 724,
//     prepared_rate_jacobian 4787.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Four-link bobbin holder, let go
    ///
    /// The holder of \`winder_linkage\` with package and post lifted: it falls until the bobbin meets
    /// the drum and the post its stop, bounces, and settles at work. Drum and stop only push: both
    /// contacts are springs and dampers that open and close by events. The drum stands still.
    ///
    /// Source: Study of a winding mechanism; dimensions are ours.
    WinderHolderDrop: "winder_holder_drop", "Four-link bobbin holder, let go";
    run from 0.0, until 1.0, points 1001, rtol 1e-7, method "auto";
    quadratures 0, discontinuities 0;
    events; constraints; prepared;
}

::machinist_contract::parameters! {
    lift: 0.03, "rad", "lift", "angle of the post over its stop at the start";
    spring_stiffness: 2000.0, "N/m", "spring.stiffness", "spring";
    spring_damping: 400.0, "N s/m", "spring.damping", "damper";
    contact_stiffness: 1_000_000.0, "N/m", "contact.stiffness", "spring of the contact";
    contact_damping: 1500.0, "N s/m", "contact.damping", "damper of the contact";
}

::machinist_contract::outputs! {
    contact_force: "N", "contact_force", "force of the contact";
    stop_force: "N", "stop_force", "force of the contact";
    contact_gap: "m", "contact_gap", "gap between bobbin and drum at K";
    stop_gap: "m", "stop_gap", "gap between post and stop at T";
    strut_push: "N", "strut_push", "force with which it pushes its ends apart";
    post_angle: "rad", "post_angle", "angle of the bar from sideways";
    plate_angle: "rad", "plate_angle", "angle of the bar from sideways";
}

::machinist_contract::states! {
    POST_X: position guess, 0.1, "m", "post.x", "centre of mass, sideways";
    POST_Y: position guess, 0.1, "m", "post.y", "centre of mass, upwards";
    POST_PHI: position, 1.0, "rad", "post.phi", "angle of the bar from sideways";
    PLATE_X: position guess, 0.1, "m", "plate.x", "centre of mass, sideways";
    PLATE_Y: position guess, 0.1, "m", "plate.y", "centre of mass, upwards";
    PLATE_PHI: position, 1.0, "rad", "plate.phi", "angle of the bar from sideways";
    CYLINDER_X: position guess, 0.1, "m", "cylinder.x", "centre of mass, sideways";
    CYLINDER_Y: position guess, 0.1, "m", "cylinder.y", "centre of mass, upwards";
    CYLINDER_PHI: position guess, 1.0, "rad", "cylinder.phi", "angle of the bar from sideways";
    ROD_X: position guess, 0.1, "m", "rod.x", "centre of mass, sideways";
    ROD_Y: position guess, 0.1, "m", "rod.y", "centre of mass, upwards";
    ROD_PHI: position guess, 1.0, "rad", "rod.phi", "angle of the bar from sideways";
    BOBBIN_X: position guess, 0.1, "m", "bobbin.x", "centre of mass, sideways";
    BOBBIN_Y: position guess, 0.1, "m", "bobbin.y", "centre of mass, upwards";
    POST_V_X: velocity guess, 1.0, "m/s", "post.v_x", "rate of centre of mass, sideways";
    POST_V_Y: velocity guess, 1.0, "m/s", "post.v_y", "rate of centre of mass, upwards";
    POST_OMEGA: velocity, 10.0, "rad/s", "post.omega", "rate of angle of the bar from sideways";
    PLATE_V_X: velocity guess, 1.0, "m/s", "plate.v_x", "rate of centre of mass, sideways";
    PLATE_V_Y: velocity guess, 1.0, "m/s", "plate.v_y", "rate of centre of mass, upwards";
    PLATE_OMEGA: velocity, 10.0, "rad/s", "plate.omega", "rate of angle of the bar from sideways";
    CYLINDER_V_X: velocity guess, 1.0, "m/s", "cylinder.v_x", "rate of centre of mass, sideways";
    CYLINDER_V_Y: velocity guess, 1.0, "m/s", "cylinder.v_y", "rate of centre of mass, upwards";
    CYLINDER_OMEGA: velocity guess, 10.0, "rad/s", "cylinder.omega", "rate of angle of the bar from sideways";
    ROD_V_X: velocity guess, 1.0, "m/s", "rod.v_x", "rate of centre of mass, sideways";
    ROD_V_Y: velocity guess, 1.0, "m/s", "rod.v_y", "rate of centre of mass, upwards";
    ROD_OMEGA: velocity guess, 10.0, "rad/s", "rod.omega", "rate of angle of the bar from sideways";
    BOBBIN_V_X: velocity guess, 1.0, "m/s", "bobbin.v_x", "rate of centre of mass, sideways";
    BOBBIN_V_Y: velocity guess, 1.0, "m/s", "bobbin.v_y", "rate of centre of mass, upwards";
    CONTACT_CLOSED: mode, 1.0, "1", "contact.closed", "1 while there is contact";
    STOP_CLOSED: mode, 1.0, "1", "stop.closed", "1 while there is contact";
}

::machinist_contract::events! {
    "contact.touches": Falling, when [(28, 0.0)], sets [28], "contact begins";
    "contact.opens": Falling, when [(28, 1.0)], sets [28], "the contact would pull";
    "stop.touches": Falling, when [(29, 0.0)], sets [29], "contact begins";
    "stop.opens": Falling, when [(29, 1.0)], sets [29], "the contact would pull";
}

::machinist_contract::constraints! {
    "pin_o_x": of_positions, "m", "pin O in the frame, sideways";
    "pin_o_y": of_positions, "m", "pin O in the frame, upwards";
    "pin_c_x": of_positions, "m", "pin C of post and plate, sideways";
    "pin_c_y": of_positions, "m", "pin C of post and plate, upwards";
    "pin_d_x": of_positions, "m", "pin D of plate and cylinder, sideways";
    "pin_d_y": of_positions, "m", "pin D of plate and cylinder, upwards";
    "slide_angle": of_positions, "1", "S: rod and cylinder are parallel";
    "slide_across": of_positions, "m", "S: and in line";
    "pin_e_x": of_positions, "m", "pin E in the frame, sideways";
    "pin_e_y": of_positions, "m", "pin E in the frame, upwards";
    "axle_a_x": of_positions, "m", "axle A of the bobbin on the plate, sideways";
    "axle_a_y": of_positions, "m", "axle A of the bobbin on the plate, upwards";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 14 by 14 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] 8 [8] 9 [9]
        10 [10] 11 [11] 12 [12] 13 [13] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 30 by 30 { 0 [14] 1 [15] 2 [16] 3 [17] 4 [18] 5 [19] 6 [20] 7 [21]
        8 [22] 9 [23] 10 [24] 11 [25] 12 [26] 13 [27]
        14 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        15 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        16 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        17 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        18 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        19 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        20 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        21 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        22 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        23 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        24 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        25 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        26 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27]
        27 [2 5 6 7 8 9 10 11 12 13 16 19 20 21 22 23 24 25 26 27] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 30 by 5 { 14 [1 2 3 4] 15 [1 2 3 4] 16 [1 2 3 4] 17 [1 2 3 4]
        18 [1 2 3 4] 19 [1 2 3 4] 20 [1 2 3 4] 21 [1 2 3 4] 22 [1 2 3 4] 23 [1 2 3 4] 24 [1 2 3 4]
        25 [1 2 3 4] 26 [1 2 3 4] 27 [1 2 3 4] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 12 by 14 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6 8]
        5 [4 5 7 8] 6 [8 11] 7 [6 7 8 9 10] 8 [9 11] 9 [10 11] 10 [3 5 12] 11 [4 5 13] }
}

::machinist_contract::constants! {
    t0
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run. 1 operation.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.contact_damping;
    Constants { t0 }
}

/// State at the start of the run, in the units of the states. 1 operation.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.096), R::literal(0.03), p.lift + R::literal(0.298_498_931_586_179_3),
        R::literal(0.172), R::literal(0.116), R::literal(1.95), R::literal(0.103),
        R::literal(0.207), R::literal(2.53), R::literal(0.049), R::literal(0.245),
        R::literal(2.53), R::literal(0.269), R::literal(0.139), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 724 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        _c: &Constants<R>) -> [R; STATES] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y,
        plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
        bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let t1 = R::literal(0.1) * sin_post_phi;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * sin_rod_phi;
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let t7 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8).add_product(t9, t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t9) / between;
    let t10 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t10)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t11 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t12 = R::literal(0.01) * t11;
    let t13 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t14 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t15 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t16 = R::literal(24.0) * sin_plate_phi;
    let t17 = R::literal(24.0) * cos_plate_phi;
    let t18 = R::literal(4.0) * t11;
    let t19 = t13 * R::literal(400.0);
    let t20 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t22 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t23 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t24 = slide * R::literal(2_777.777_777_777_778);
    let t25 = sin_cylinder_phi * R::literal(5.0);
    let t26 = cos_cylinder_phi * R::literal(5.0);
    let t27 = R::literal(250.0) * sin_rod_phi;
    let t28 = R::literal(250.0) * cos_rod_phi;
    let t29 = t14 * t1;
    let t30 = R::literal(1.25) + t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t15 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t15 * t0;
    let t37 = R::literal(1.25) + t36;
    let t38 = t33 * t32;
    let t39 = R::literal(1.0) / (t38 - t37);
    let t40 = (t14 * t0).add_product(t35, t32);
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t36 + t38;
    let t43 = t42 * t39;
    let t44 = t16 * t3;
    let t45 = R::literal(1.0) / (-(t30 + R::literal(0.833_333_333_333_333_4) + t44))
        .add_product(t35, t34).sub_product(t41, t40);
    let t46 = t17 * t3;
    let t47 = (t32 + t46).add_product(t33, t34).sub_product(t43, t40);
    let t48 = t47 * t45;
    let t49 = R::literal(0.833_333_333_333_333_4) - t44;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t18 * t3;
    let t53 = R::literal(0.833_333_333_333_333_4) + t52;
    let t54 = t53 * t45;
    let t55 = t19 * t3;
    let t56 = t55 * t45;
    let t57 = t17 * t2;
    let t58 = R::literal(1.0) / (t38 - (t37 + R::literal(0.833_333_333_333_333_4) + t57))
        .sub_product(t43, t42).sub_product(t48, t47);
    let t59 = (t16 * t2).sub_product(t50, t47);
    let t60 = t59 * t58;
    let t61 = (R::literal(0.833_333_333_333_333_4) - t57).sub_product(t51, t47);
    let t62 = t61 * t58;
    let t63 = t18 * t2;
    let t64 = t63.add_product(t54, t47);
    let t65 = t64 * t58;
    let t66 = t19 * t2;
    let t67 = (R::literal(0.833_333_333_333_333_4) + t66).add_product(t56, t47);
    let t68 = t67 * t58;
    let t69 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t44
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t5).add_product(t50, t49)
        .add_product(t60, t59);
    let t70 = t46.add_product(t23, t5).sub_product(t51, t49).sub_product(t62, t59);
    let t71 = t70 * t69;
    let t72 = t22 * t69;
    let t73 = (-t20).add_product(t24, t5);
    let t74 = t73 * t69;
    let t75 = (t52 - R::literal(0.833_333_333_333_333_4)).sub_product(t54, t49).add_product(t65,
        t59);
    let t76 = t75 * t69;
    let t77 = (-t55).add_product(t56, t49).sub_product(t68, t59);
    let t78 = t77 * t69;
    let t79 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t57
        + R::literal(3.333_333_333_333_333_5)).add_product(t23, t4).add_product(t51, t46)
        .add_product(t62, t61)).add_product(t71, t70);
    let t80 = (-t23).add_product(t72, t70);
    let t81 = t80 * t79;
    let t82 = t21.sub_product(t24, t4).add_product(t74, t70);
    let t83 = t82 * t79;
    let t84 = (-t63.add_product(t54, t46)).add_product(t65, t61).add_product(t76, t70);
    let t85 = t84 * t79;
    let t86 = (t66 - R::literal(0.833_333_333_333_333_4)).add_product(t56, t46).sub_product(t68,
        t61).add_product(t78, t70);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t72, t22)
        .sub_product(t81, t80);
    let t89 = (-t24).add_product(t74, t22).sub_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t27 * t88;
    let t92 = t28 * t88;
    let t93 = (t76 * t22).sub_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t22).sub_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0) / (-(t20 * sin_cylinder_phi).add_product(t21, cos_cylinder_phi)
        .add_product(t24, slide).add_product(t25, sin_cylinder_phi).add_product(t26,
        cos_cylinder_phi)).add_product(t74, t73).sub_product(t83, t82).sub_product(t90, t89);
    let t98 = t25.sub_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = (-t26).add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (t76 * t73).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (t78 * t73).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / R::literal(5.0).add_product(t27, t6).add_product(t91, t27)
        .add_product(t99, t98);
    let t107 = (t28 * t6).add_product(t92, t27).sub_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (t94 * t27).add_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (t96 * t27).add_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0) / (-R::literal(5.0).add_product(t28, R::literal(0.06) * cos_rod_phi)
        .add_product(t92, t28).add_product(t101, t100)).add_product(t108, t107);
    let t114 = (t94 * t28).sub_product(t103, t100).sub_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (t96 * t28).sub_product(t105, t100).sub_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t12)
        + R::literal(1.428_571_428_571_428_6)).add_product(t54, t53).add_product(t65, t64))
        .add_product(t76, t75).sub_product(t85, t84).sub_product(t94, t93).sub_product(t103, t102)
        .add_product(t110, t109).sub_product(t115, t114);
    let t119 = (t19 * t12).add_product(t56, t53).add_product(t68, t64).add_product(t78, t75)
        .sub_product(t87, t84).sub_product(t96, t93).sub_product(t105, t102).add_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t7).add_product(R::literal(1500.0) * stop_rate, t7));
    let t122 = p.spring_stiffness * (slide - R::literal(0.116));
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t123 = (t122 * cos_cylinder_phi).add_product(spring_damping_times_slide_rate,
        cos_cylinder_phi);
    let t124 = t122 * sin_cylinder_phi;
    let t125 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t126 = t125 - (R::literal(2.943) - t124);
    let t127 = (t122 * t10).add_product(spring_damping_times_slide_rate, t10);
    let t128 = t125 + (R::literal(1.962) + t124);
    let t129 = R::literal(0.1) * (post_omega * post_omega);
    let t130 = t129 * cos_post_phi;
    let t131 = t129 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t132 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t133 = R::literal(0.06) * (rod_omega * rod_omega);
    let t134 = t14 * t121;
    let t135 = t130 + t134;
    let t136 = t15 * t121;
    let t137 = t33 * t135;
    let t138 = R::literal(9.81) - t131 + t136 - t137;
    let t139 = (t130.add_product(t132, cos_plate_phi) + t134).add_product(t35, t135)
        .add_product(t41, t138);
    let t140 = (t136 - (t131.add_product(t132, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) - t137).sub_product(t43, t138).add_product(t48, t139);
    let t141 = R::literal(3.333_333_333_333_333_5) * t123;
    let t142 = (-t141.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))).add_product(t22, t127)
        .add_product(t50, t139).sub_product(t60, t140);
    let t143 = R::literal(3.333_333_333_333_333_5) * t126;
    let t144 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t143)
        .add_product(t23, t127)).add_product(t51, t139).sub_product(t62, t140).add_product(t71,
        t142);
    let t145 = R::literal(2_777.777_777_777_778) * t127;
    let t146 = (-t145).add_product(t72, t142).sub_product(t81, t144);
    let t147 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t20, t123)
        .add_product(t21, t126).sub_product(t24, t127).sub_product(t25, t123).add_product(t26, t128)
        .add_product(t74, t142).sub_product(t83, t144);
    let t148 = t147.sub_product(t90, t146);
    let t149 = R::literal(5.0) * t123;
    let t150 = t149.add_product(t133, cos_rod_phi).sub_product(t91, t146).sub_product(t99, t148);
    let t151 = R::literal(5.0) * t128;
    let t152 = t151.add_product(t133, sin_rod_phi).add_product(t92, t146).sub_product(t101, t148)
        .add_product(t108, t150);
    let t153 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_stiffness_times_contact_gap * t8 / between
        + contact_damping_times_contact_rate * t8 / between));
    let t154 = (-t153).add_product(t13, plate_omega_squared).add_product(t54, t139)
        .add_product(t65, t140).add_product(t76, t142).sub_product(t85, t144).sub_product(t94, t146)
        .sub_product(t103, t148).sub_product(t110, t150).sub_product(t115, t152);
    let t155 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_damping_times_contact_rate * t9 / between))
        - (R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t9 / between)));
    let t156 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared) - t155).sub_product(t56,
        t139).sub_product(t68, t140).add_product(t78, t142).sub_product(t87, t144).sub_product(t96,
        t146).sub_product(t105, t148).sub_product(t112, t150).sub_product(t117, t152)
        .sub_product(t120, t154);
    let t157 = t156 * (R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t19,
        t13) + R::literal(1.428_571_428_571_428_6)).add_product(t56, t55).add_product(t68, t67))
        .add_product(t78, t77).sub_product(t87, t86).sub_product(t96, t95).sub_product(t105, t104)
        .add_product(t112, t111).sub_product(t117, t116).sub_product(t120, t119));
    let t158 = (t154 * t118).sub_product(t120, t157);
    let t159 = (t152 * t113).sub_product(t115, t158).sub_product(t117, t157);
    let t160 = (-(t150 * t106)).add_product(t108, t159).sub_product(t110, t158).sub_product(t112,
        t157);
    let t161 = (t148 * t97).sub_product(t99, t160).sub_product(t101, t159).sub_product(t103, t158)
        .sub_product(t105, t157);
    let t162 = (t146 * t88).sub_product(t90, t161).sub_product(t91, t160).add_product(t92, t159)
        .sub_product(t94, t158).sub_product(t96, t157);
    let t163 = (t144 * t79).sub_product(t81, t162).sub_product(t83, t161).sub_product(t85, t158)
        .sub_product(t87, t157);
    let t164 = (-(t142 * t69)).add_product(t71, t163).add_product(t72, t162).add_product(t74, t161)
        .add_product(t76, t158).add_product(t78, t157);
    let t165 = (t140 * t58).sub_product(t60, t164).sub_product(t62, t163).add_product(t65, t158)
        .sub_product(t68, t157);
    let t166 = (-(t139 * t45).add_product(t48, t165).add_product(t50, t164).add_product(t51, t163)
        .add_product(t54, t158)).add_product(t56, t157);
    let t167 = (t138 * t39).sub_product(t41, t166).sub_product(t43, t165);
    let t168 = (t135 * t31).add_product(t33, t167).add_product(t35, t166).add_product(t33, t165);
    let bobbin_v_y_dot = t155.sub_product(R::literal(1.428_571_428_571_428_6), t157);
    let bobbin_v_x_dot = t153.sub_product(R::literal(1.428_571_428_571_428_6), t158);
    let rod_omega_dot = (t27 * t160).sub_product(R::literal(4_166.666_666_666_667), t162)
        .sub_product(t28, t159);
    let rod_v_y_dot = -t151.add_product(t26, t161).add_product(R::literal(5.0), t159);
    let rod_v_x_dot = (-t149).add_product(t25, t161).sub_product(R::literal(5.0), t160);
    let cylinder_omega_dot = (-t145.add_product(t22, t164)).add_product(t23, t163)
        .add_product(R::literal(2_777.777_777_777_778), t162).add_product(t24, t161);
    let cylinder_v_y_dot = t143.sub_product(R::literal(3.333_333_333_333_333_5), t163)
        .add_product(t21, t161);
    let cylinder_v_x_dot = t141.sub_product(R::literal(3.333_333_333_333_333_5), t164)
        .sub_product(t20, t161);
    let plate_omega_dot = (t17 * t165).sub_product(t16, t166).sub_product(t16, t164)
        .add_product(t17, t163).add_product(t18, t158).sub_product(t19, t157);
    let plate_v_y_dot = (-R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t165))
        .add_product(R::literal(0.833_333_333_333_333_4), t163)
        .add_product(R::literal(0.833_333_333_333_333_4), t157);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t164)
        .sub_product(R::literal(0.833_333_333_333_333_4), t166)
        .add_product(R::literal(0.833_333_333_333_333_4), t158);
    let post_omega_dot = (t121 * R::literal(370.370_370_370_370_3)).sub_product(t14, t168)
        .add_product(t15, t167).sub_product(t14, t166).add_product(t15, t165);
    let post_v_y_dot = (-R::literal(9.81).add_product(R::literal(1.25), t167))
        .add_product(R::literal(1.25), t165);
    let post_v_x_dot = (R::literal(1.25) * t166).sub_product(R::literal(1.25), t168);
    [post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
        cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, post_v_x_dot,
        post_v_y_dot, post_omega_dot, plate_v_x_dot, plate_v_y_dot, plate_omega_dot,
        cylinder_v_x_dot, cylinder_v_y_dot, cylinder_omega_dot, rod_v_x_dot, rod_v_y_dot,
        rod_omega_dot, bobbin_v_x_dot, bobbin_v_y_dot, R::literal(0.0), R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 14] {
    [R::literal(0.8), R::literal(0.8), R::literal(0.0027), R::literal(1.2), R::literal(1.2),
        R::literal(0.0025), R::literal(0.3), R::literal(0.3), R::literal(0.00036), R::literal(0.2),
        R::literal(0.2), R::literal(0.00024), R::literal(0.7), R::literal(0.7)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 80 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [_, _, post_phi, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _, bobbin_x,
        bobbin_y, _, _, post_omega, _, _, _, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_cylinder_phi, cos_cylinder_phi)]
        = R::sin_cos_each([post_phi, cylinder_phi]);
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let t0 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t0;
    let t1 = bobbin_x - R::literal(0.328);
    let t2 = bobbin_y - R::literal(0.058);
    let between = (t1 * t1).add_product(t2, t2).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t1).add_product(bobbin_v_y, t2) / between;
    let t3 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t3)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let post_phi_forcing = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t0).add_product(R::literal(1500.0) * stop_rate, t0));
    let t4 = p.spring_stiffness * (slide - R::literal(0.116));
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let cylinder_x_forcing = (t4 * cos_cylinder_phi).add_product(spring_damping_times_slide_rate,
        cos_cylinder_phi);
    let t5 = t4 * sin_cylinder_phi;
    let t6 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let cylinder_y_forcing = t6 - (R::literal(2.943) - t5);
    let cylinder_phi_forcing = -(t4 * t3).add_product(spring_damping_times_slide_rate, t3);
    let rod_x_forcing = -cylinder_x_forcing;
    let rod_y_forcing = -(t6 + (R::literal(1.962) + t5));
    let bobbin_x_forcing = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(contact_stiffness_times_contact_gap * t1 / between + contact_damping_times_contact_rate
        * t1 / between));
    let bobbin_y_forcing = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(contact_damping_times_contact_rate * t2 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t2 / between));
    [R::literal(0.0), R::literal(-7.848), post_phi_forcing, R::literal(0.0), R::literal(-11.772),
        R::literal(0.0), cylinder_x_forcing, cylinder_y_forcing, cylinder_phi_forcing,
        rod_x_forcing, rod_y_forcing, R::literal(0.0), bobbin_x_forcing, bobbin_y_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 4787 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 294] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, _, post_omega, _, _, plate_omega, cylinder_v_x,
        cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y,
        contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let t1 = R::literal(0.1) * sin_post_phi;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * cos_rod_phi;
    let t7 = R::literal(0.06) * sin_rod_phi;
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let t8 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t8;
    let t9 = bobbin_x - R::literal(0.328);
    let t10 = t9 * t9;
    let t11 = bobbin_y - R::literal(0.058);
    let t12 = t11 * t11;
    let between = (t10 + t12).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t9).add_product(bobbin_v_y, t11) / between;
    let t13 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t14 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t15 = t14 - t13;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi).add_product(cylinder_omega,
        t15).add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t16 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t17 = R::literal(0.01) * t16;
    let t18 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t19 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t20 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t21 = R::literal(24.0) * sin_plate_phi;
    let t22 = R::literal(24.0) * cos_plate_phi;
    let t23 = R::literal(4.0) * t16;
    let t24 = t18 * R::literal(400.0);
    let t25 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t26 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t27 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t28 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t29 = slide * R::literal(2_777.777_777_777_778);
    let t30 = sin_cylinder_phi * R::literal(5.0);
    let t31 = cos_cylinder_phi * R::literal(5.0);
    let t32 = R::literal(250.0) * sin_rod_phi;
    let t33 = R::literal(250.0) * cos_rod_phi;
    let t34 = t19 * t1;
    let t35 = R::literal(1.25) + t34;
    let t36 = R::literal(1.0) / t35;
    let t37 = t20 * t1;
    let t38 = t37 * t36;
    let t39 = R::literal(1.25) - t34;
    let t40 = t39 * t36;
    let t41 = t20 * t0;
    let t42 = R::literal(1.25) + t41;
    let t43 = t38 * t37;
    let t44 = R::literal(1.0) / (t43 - t42);
    let t45 = (t19 * t0).add_product(t40, t37);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 + t43;
    let t48 = t47 * t44;
    let t49 = t21 * t3;
    let t50 = R::literal(1.0) / (-(t35 + R::literal(0.833_333_333_333_333_4) + t49))
        .add_product(t40, t39).sub_product(t46, t45);
    let t51 = t22 * t3;
    let t52 = (t37 + t51).add_product(t38, t39).sub_product(t48, t45);
    let t53 = t52 * t50;
    let t54 = R::literal(0.833_333_333_333_333_4) - t49;
    let t55 = t54 * t50;
    let t56 = t51 * t50;
    let t57 = t23 * t3;
    let t58 = R::literal(0.833_333_333_333_333_4) + t57;
    let t59 = t58 * t50;
    let t60 = t24 * t3;
    let t61 = t60 * t50;
    let t62 = t22 * t2;
    let t63 = R::literal(1.0) / (t43 - (t42 + R::literal(0.833_333_333_333_333_4) + t62))
        .sub_product(t48, t47).sub_product(t53, t52);
    let t64 = (t21 * t2).sub_product(t55, t52);
    let t65 = t64 * t63;
    let t66 = (R::literal(0.833_333_333_333_333_4) - t62).sub_product(t56, t52);
    let t67 = t66 * t63;
    let t68 = t23 * t2;
    let t69 = t68.add_product(t59, t52);
    let t70 = t69 * t63;
    let t71 = t24 * t2;
    let t72 = (R::literal(0.833_333_333_333_333_4) + t71).add_product(t61, t52);
    let t73 = t72 * t63;
    let t74 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t49
        + R::literal(3.333_333_333_333_333_5)).add_product(t27, t5).add_product(t55, t54)
        .add_product(t65, t64);
    let t75 = t51.add_product(t28, t5).sub_product(t56, t54).sub_product(t67, t64);
    let t76 = t75 * t74;
    let t77 = t27 * t74;
    let t78 = (-t25).add_product(t29, t5);
    let t79 = t78 * t74;
    let t80 = (t57 - R::literal(0.833_333_333_333_333_4)).sub_product(t59, t54).add_product(t70,
        t64);
    let t81 = t80 * t74;
    let t82 = (-t60).add_product(t61, t54).sub_product(t73, t64);
    let t83 = t82 * t74;
    let t84 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t62
        + R::literal(3.333_333_333_333_333_5)).add_product(t28, t4).add_product(t56, t51)
        .add_product(t67, t66)).add_product(t76, t75);
    let t85 = (-t28).add_product(t77, t75);
    let t86 = t85 * t84;
    let t87 = t26.sub_product(t29, t4).add_product(t79, t75);
    let t88 = t87 * t84;
    let t89 = (-t68.add_product(t59, t51)).add_product(t70, t66).add_product(t81, t75);
    let t90 = t89 * t84;
    let t91 = (t71 - R::literal(0.833_333_333_333_333_4)).add_product(t61, t51).sub_product(t73,
        t66).add_product(t83, t75);
    let t92 = t91 * t84;
    let t93 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t77, t27)
        .sub_product(t86, t85);
    let t94 = (-t29).add_product(t79, t27).sub_product(t88, t85);
    let t95 = t94 * t93;
    let t96 = t32 * t93;
    let t97 = t33 * t93;
    let t98 = (t81 * t27).sub_product(t90, t85);
    let t99 = t98 * t93;
    let t100 = (t83 * t27).sub_product(t92, t85);
    let t101 = t100 * t93;
    let t102 = R::literal(1.0) / (-(t25 * sin_cylinder_phi).add_product(t26, cos_cylinder_phi)
        .add_product(t29, slide).add_product(t30, sin_cylinder_phi).add_product(t31,
        cos_cylinder_phi)).add_product(t79, t78).sub_product(t88, t87).sub_product(t95, t94);
    let t103 = t30.sub_product(t96, t94);
    let t104 = t103 * t102;
    let t105 = (-t31).add_product(t97, t94);
    let t106 = t105 * t102;
    let t107 = (t81 * t78).sub_product(t90, t87).sub_product(t99, t94);
    let t108 = t107 * t102;
    let t109 = (t83 * t78).sub_product(t92, t87).sub_product(t101, t94);
    let t110 = t109 * t102;
    let t111 = R::literal(1.0) / R::literal(5.0).add_product(t32, t7).add_product(t96, t32)
        .add_product(t104, t103);
    let t112 = (t33 * t7).add_product(t97, t32).sub_product(t106, t103);
    let t113 = t112 * t111;
    let t114 = (t99 * t32).add_product(t108, t103);
    let t115 = t114 * t111;
    let t116 = (t101 * t32).add_product(t110, t103);
    let t117 = t116 * t111;
    let t118 = R::literal(1.0) / (-R::literal(5.0).add_product(t33, t6).add_product(t97, t33)
        .add_product(t106, t105)).add_product(t113, t112);
    let t119 = (t99 * t33).sub_product(t108, t105).sub_product(t115, t112);
    let t120 = t119 * t118;
    let t121 = (t101 * t33).sub_product(t110, t105).sub_product(t117, t112);
    let t122 = t121 * t118;
    let t123 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t23, t17)
        + R::literal(1.428_571_428_571_428_6)).add_product(t59, t58).add_product(t70, t69))
        .add_product(t81, t80).sub_product(t90, t89).sub_product(t99, t98).sub_product(t108, t107)
        .add_product(t115, t114).sub_product(t120, t119);
    let t124 = (t24 * t17).add_product(t61, t58).add_product(t73, t69).add_product(t83, t80)
        .sub_product(t92, t89).sub_product(t101, t98).sub_product(t110, t107).add_product(t117,
        t114).sub_product(t122, t119);
    let t125 = t124 * t123;
    let t126 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t24, t18)
        + R::literal(1.428_571_428_571_428_6)).add_product(t61, t60).add_product(t73, t72))
        .add_product(t83, t82).sub_product(t92, t91).sub_product(t101, t100).sub_product(t110, t109)
        .add_product(t117, t116).sub_product(t122, t121).sub_product(t125, t124);
    let t127 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t8).add_product(R::literal(1500.0) * stop_rate, t8));
    let t128 = slide - R::literal(0.116);
    let t129 = p.spring_stiffness * t128;
    let t130 = t129 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t131 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t132 = t130 + t131;
    let t133 = t129 * sin_cylinder_phi;
    let t134 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t135 = t134 - (R::literal(2.943) - t133);
    let t136 = (t129 * t15).add_product(spring_damping_times_slide_rate, t15);
    let t137 = t134 + (R::literal(1.962) + t133);
    let t138 = contact_stiffness_times_contact_gap * t9;
    let t139 = R::literal(0.1) * (post_omega * post_omega);
    let t140 = t139 * cos_post_phi;
    let t141 = t139 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t142 = R::literal(0.06) * plate_omega_squared;
    let t143 = t142 * cos_plate_phi;
    let t144 = t142 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t145 = cylinder_omega_squared * cos_cylinder_phi;
    let t146 = cylinder_omega_squared * sin_cylinder_phi;
    let t147 = R::literal(2.0) * cylinder_v_x;
    let t148 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t149 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t150 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t151 = R::literal(2.0) * rod_v_x;
    let t152 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t153 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t154 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t155 = R::literal(0.06) * (rod_omega * rod_omega);
    let t156 = t155 * cos_rod_phi;
    let t157 = t155 * sin_rod_phi;
    let t158 = t18 * plate_omega_squared;
    let t159 = t19 * t127;
    let t160 = t140 + t159;
    let t161 = t20 * t127;
    let t162 = t38 * t160;
    let t163 = R::literal(9.81) - t141 + t161 - t162;
    let t164 = (t143 + t140 + t159).add_product(t40, t160).add_product(t46, t163);
    let t165 = (t161 - (t144 + t141 + R::literal(9.81)) + R::literal(9.81) - t162).sub_product(t48,
        t163).add_product(t53, t164);
    let t166 = R::literal(3.333_333_333_333_333_5) * t132;
    let t167 = (-t166.add_product(R::literal(0.06), t145.add_product(plate_omega_squared,
        cos_plate_phi))).add_product(t27, t136).add_product(t55, t164).sub_product(t65, t165);
    let t168 = R::literal(3.333_333_333_333_333_5) * t135;
    let t169 = (-(R::literal(9.81).add_product(R::literal(0.06), t146
        .add_product(plate_omega_squared, sin_plate_phi)) + t168).add_product(t28, t136))
        .add_product(t56, t164).sub_product(t67, t165).add_product(t76, t167);
    let t170 = R::literal(2_777.777_777_777_778) * t136;
    let t171 = (-t170).add_product(t77, t167).sub_product(t86, t169);
    let t172 = (cylinder_omega * (((t151 * cos_cylinder_phi).add_product(t152, sin_cylinder_phi)
        + t153 + t154).sub_product(t147, cos_cylinder_phi).sub_product(t148, sin_cylinder_phi)
        - t149 - t150)).sub_product(t25, t132).add_product(t26, t135).sub_product(t29, t136)
        .sub_product(t30, t132).add_product(t31, t137).add_product(t79, t167).sub_product(t88, t169)
        .sub_product(t95, t171);
    let t173 = R::literal(5.0) * t132;
    let t174 = (t156 + t173).sub_product(t96, t171).sub_product(t104, t172);
    let t175 = R::literal(5.0) * t137;
    let t176 = (t157 + t175).add_product(t97, t171).sub_product(t106, t172).add_product(t113, t174);
    let t177 = t158.sub_product(R::literal(1.428_571_428_571_428_6), R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t138 / between + contact_damping_times_contact_rate
        * t9 / between))).add_product(t59, t164).add_product(t70, t165).add_product(t81, t167)
        .sub_product(t90, t169).sub_product(t99, t171).sub_product(t108, t172).sub_product(t115,
        t174).sub_product(t120, t176);
    let t178 = R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared)
        .sub_product(R::literal(1.428_571_428_571_428_6), R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_damping_times_contact_rate * t11 / between))
        - (R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t11 / between))).sub_product(t61, t164)
        .sub_product(t73, t165).add_product(t83, t167).sub_product(t92, t169).sub_product(t101,
        t171).sub_product(t110, t172).sub_product(t117, t174).sub_product(t122, t176)
        .sub_product(t125, t177) * t126;
    let t179 = (t177 * t123).sub_product(t125, t178);
    let t180 = (t176 * t118).sub_product(t120, t179).sub_product(t122, t178);
    let t181 = (-(t174 * t111)).add_product(t113, t180).sub_product(t115, t179).sub_product(t117,
        t178);
    let t182 = (t172 * t102).sub_product(t104, t181).sub_product(t106, t180).sub_product(t108, t179)
        .sub_product(t110, t178);
    let t183 = (t171 * t93).sub_product(t95, t182).sub_product(t96, t181).add_product(t97, t180)
        .sub_product(t99, t179).sub_product(t101, t178);
    let t184 = (t169 * t84).sub_product(t86, t183).sub_product(t88, t182).sub_product(t90, t179)
        .sub_product(t92, t178);
    let t185 = (-(t167 * t74)).add_product(t76, t184).add_product(t77, t183).add_product(t79, t182)
        .add_product(t81, t179).add_product(t83, t178);
    let t186 = (t165 * t63).sub_product(t65, t185).sub_product(t67, t184).add_product(t70, t179)
        .sub_product(t73, t178);
    let t187 = (-(t164 * t50).add_product(t53, t186).add_product(t55, t185).add_product(t56, t184)
        .add_product(t59, t179)).add_product(t61, t178);
    let t188 = (t163 * t44).sub_product(t46, t187).sub_product(t48, t186);
    let t189 = (t160 * t36).add_product(t38, t188).add_product(t40, t187).add_product(t38, t186);
    let rod_omega_dot = (t32 * t181).sub_product(R::literal(4_166.666_666_666_667), t183)
        .sub_product(t33, t180);
    let rod_v_x_dot = (-t173).add_product(t30, t182).sub_product(R::literal(5.0), t181);
    let cylinder_omega_dot = (-t170.add_product(t27, t185)).add_product(t28, t184)
        .add_product(R::literal(2_777.777_777_777_778), t183).add_product(t29, t182);
    let cylinder_v_y_dot = t168.sub_product(R::literal(3.333_333_333_333_333_5), t184)
        .add_product(t26, t182);
    let cylinder_v_x_dot = t166.sub_product(R::literal(3.333_333_333_333_333_5), t185)
        .sub_product(t25, t182);
    let plate_omega_dot = (t22 * t186).sub_product(t21, t187).sub_product(t21, t185)
        .add_product(t22, t184).add_product(t23, t179).sub_product(t24, t178);
    let post_omega_dot = (t127 * R::literal(370.370_370_370_370_3)).sub_product(t19, t189)
        .add_product(t20, t188).sub_product(t19, t187).add_product(t20, t186);
    let t190 = t8 * t8;
    let t191 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), (R::literal(3000.0)
        * stop_gap * stop_rate).add_product(R::literal(1_000_000.0), stop_gap * stop_gap)
        .sub_product(R::literal(1_000_000.0), t190)).sub_product(t0, t189).sub_product(t1, t188)
        .sub_product(t0, t187).sub_product(t1, t186);
    let t192 = t141.sub_product(t0, post_omega_dot).sub_product(t19, t191);
    let t193 = (-t140.add_product(t1, post_omega_dot)).add_product(t20, t191).add_product(t38,
        t192);
    let t194 = t192.add_product(t40, t192).sub_product(t46, t193);
    let t195 = t193.sub_product(t48, t193).sub_product(t53, t194);
    let t196 = (t55 * t194).add_product(t65, t195);
    let t197 = (t56 * t194).add_product(t67, t195).add_product(t76, t196);
    let t198 = (-(t77 * t196)).add_product(t86, t197);
    let t199 = (-(t79 * t196)).add_product(t88, t197).sub_product(t95, t198);
    let t200 = (t96 * t198).add_product(t104, t199);
    let t201 = (t97 * t198).sub_product(t106, t199).sub_product(t113, t200);
    let t202 = (-(t59 * t194)).add_product(t70, t195).sub_product(t81, t196).add_product(t90, t197)
        .sub_product(t99, t198).sub_product(t108, t199).add_product(t115, t200).sub_product(t120,
        t201);
    let t203 = (t61 * t194).sub_product(t73, t195).sub_product(t83, t196).add_product(t92, t197)
        .sub_product(t101, t198).sub_product(t110, t199).add_product(t117, t200).sub_product(t122,
        t201).sub_product(t125, t202) * t126;
    let t204 = (t202 * t123).sub_product(t125, t203);
    let t205 = (t201 * t118).sub_product(t120, t204).sub_product(t122, t203);
    let t206 = (t200 * t111).add_product(t113, t205).sub_product(t115, t204).sub_product(t117,
        t203);
    let t207 = (t199 * t102).sub_product(t104, t206).sub_product(t106, t205).sub_product(t108, t204)
        .sub_product(t110, t203);
    let t208 = (t198 * t93).sub_product(t95, t207).sub_product(t96, t206).add_product(t97, t205)
        .sub_product(t99, t204).sub_product(t101, t203);
    let t209 = (t197 * t84).add_product(t86, t208).add_product(t88, t207).add_product(t90, t204)
        .add_product(t92, t203);
    let t210 = (t196 * t74).sub_product(t76, t209).add_product(t77, t208).add_product(t79, t207)
        .add_product(t81, t204).add_product(t83, t203);
    let t211 = (t195 * t63).sub_product(t65, t210).add_product(t67, t209).add_product(t70, t204)
        .sub_product(t73, t203);
    let t212 = (t194 * t50).sub_product(t53, t211).sub_product(t55, t210).add_product(t56, t209)
        .sub_product(t59, t204).add_product(t61, t203);
    let t213 = (t193 * t44).sub_product(t46, t212).sub_product(t48, t211);
    let t214 = (-(t192 * t36)).add_product(t38, t213).add_product(t40, t212).add_product(t38, t211);
    let bobbin_v_y_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t203;
    let bobbin_v_x_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t204;
    let rod_omega_dot_by_post_phi = (t32 * t206).sub_product(R::literal(4_166.666_666_666_667),
        t208).sub_product(t33, t205);
    let rod_v_y_dot_by_post_phi = -(R::literal(5.0) * t205).add_product(t31, t207);
    let rod_v_x_dot_by_post_phi = (R::literal(-5.0) * t206).add_product(t30, t207);
    let cylinder_omega_dot_by_post_phi = (-(t28 * t209).add_product(t27, t210))
        .add_product(R::literal(2_777.777_777_777_778), t208).add_product(t29, t207);
    let cylinder_v_y_dot_by_post_phi = (t26 * t207)
        .add_product(R::literal(3.333_333_333_333_333_5), t209);
    let cylinder_v_x_dot_by_post_phi = -(t25 * t207)
        .add_product(R::literal(3.333_333_333_333_333_5), t210);
    let plate_omega_dot_by_post_phi = (t22 * t211).sub_product(t21, t212).sub_product(t21, t210)
        .sub_product(t22, t209).add_product(t23, t204).sub_product(t24, t203);
    let plate_v_y_dot_by_post_phi = (-(R::literal(0.833_333_333_333_333_4) * t209)
        .add_product(R::literal(0.833_333_333_333_333_4), t211))
        .add_product(R::literal(0.833_333_333_333_333_4), t203);
    let plate_v_x_dot_by_post_phi = (R::literal(0.833_333_333_333_333_4) * t210)
        .sub_product(R::literal(0.833_333_333_333_333_4), t212)
        .add_product(R::literal(0.833_333_333_333_333_4), t204);
    let post_omega_dot_by_post_phi = (t191 * R::literal(370.370_370_370_370_3)).sub_product(t19,
        t214).add_product(t20, t213).sub_product(t19, t212).add_product(t20, t211);
    let post_v_y_dot_by_post_phi = (R::literal(1.25) * t211).sub_product(R::literal(1.25), t213);
    let post_v_x_dot_by_post_phi = (R::literal(1.25) * t212).sub_product(R::literal(1.25), t214);
    let t215 = R::literal(0.01) * cos_plate_phi.sub_product(R::literal(10.0), sin_plate_phi);
    let t216 = (-(t3 * t186).add_product(t2, t187).add_product(t2, t185).add_product(t3, t184))
        .add_product(t215, t179).add_product(t17, t178);
    let t217 = t144.sub_product(t2, plate_omega_dot).sub_product(t21, t216);
    let t218 = (-t143.add_product(t3, plate_omega_dot)).add_product(t22, t216);
    let t219 = t218.sub_product(t53, t217);
    let t220 = t217.sub_product(t55, t217).sub_product(t65, t219);
    let t221 = t218.sub_product(t56, t217).sub_product(t67, t219).add_product(t76, t220);
    let t222 = (t77 * t220).sub_product(t86, t221);
    let t223 = (t79 * t220).sub_product(t88, t221).sub_product(t95, t222);
    let t224 = (t96 * t222).add_product(t104, t223);
    let t225 = (t97 * t222).sub_product(t106, t223).sub_product(t113, t224);
    let t226 = (-(t17 * plate_omega_squared)).add_product(t215, plate_omega_dot).add_product(t23,
        t216).sub_product(t59, t217).add_product(t70, t219).add_product(t81, t220).sub_product(t90,
        t221).sub_product(t99, t222).sub_product(t108, t223).add_product(t115, t224)
        .sub_product(t120, t225);
    let t227 = t158.add_product(t17, plate_omega_dot).sub_product(t24, t216).add_product(t61, t217)
        .sub_product(t73, t219).add_product(t83, t220).sub_product(t92, t221).sub_product(t101,
        t222).sub_product(t110, t223).add_product(t117, t224).sub_product(t122, t225)
        .sub_product(t125, t226) * t126;
    let t228 = (t226 * t123).sub_product(t125, t227);
    let t229 = (t225 * t118).sub_product(t120, t228).sub_product(t122, t227);
    let t230 = (t224 * t111).add_product(t113, t229).sub_product(t115, t228).sub_product(t117,
        t227);
    let t231 = (t223 * t102).sub_product(t104, t230).sub_product(t106, t229).sub_product(t108, t228)
        .sub_product(t110, t227);
    let t232 = (t222 * t93).sub_product(t95, t231).sub_product(t96, t230).add_product(t97, t229)
        .sub_product(t99, t228).sub_product(t101, t227);
    let t233 = (t221 * t84).sub_product(t86, t232).sub_product(t88, t231).sub_product(t90, t228)
        .sub_product(t92, t227);
    let t234 = (-(t220 * t74)).add_product(t76, t233).add_product(t77, t232).add_product(t79, t231)
        .add_product(t81, t228).add_product(t83, t227);
    let t235 = (t219 * t63).sub_product(t65, t234).sub_product(t67, t233).add_product(t70, t228)
        .sub_product(t73, t227);
    let t236 = (t217 * t50).sub_product(t53, t235).sub_product(t55, t234).sub_product(t56, t233)
        .sub_product(t59, t228).add_product(t61, t227);
    let t237 = (t48 * t235).add_product(t46, t236);
    let t238 = (t40 * t236).sub_product(t38, t237).add_product(t38, t235);
    let bobbin_v_y_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t227;
    let bobbin_v_x_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t228;
    let rod_omega_dot_by_plate_phi = (t32 * t230).sub_product(R::literal(4_166.666_666_666_667),
        t232).sub_product(t33, t229);
    let rod_v_y_dot_by_plate_phi = -(R::literal(5.0) * t229).add_product(t31, t231);
    let rod_v_x_dot_by_plate_phi = (R::literal(-5.0) * t230).add_product(t30, t231);
    let cylinder_omega_dot_by_plate_phi = (t28 * t233).sub_product(t27, t234)
        .add_product(R::literal(2_777.777_777_777_778), t232).add_product(t29, t231);
    let cylinder_v_y_dot_by_plate_phi = (t26 * t231)
        .sub_product(R::literal(3.333_333_333_333_333_5), t233);
    let cylinder_v_x_dot_by_plate_phi = -(t25 * t231)
        .add_product(R::literal(3.333_333_333_333_333_5), t234);
    let plate_omega_dot_by_plate_phi = (t216 * R::literal(400.0)).sub_product(t21, t236)
        .add_product(t22, t235).sub_product(t21, t234).add_product(t22, t233).add_product(t23, t228)
        .sub_product(t24, t227);
    let plate_v_y_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t233)
        .sub_product(R::literal(0.833_333_333_333_333_4), t235)
        .add_product(R::literal(0.833_333_333_333_333_4), t227);
    let plate_v_x_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t234)
        .sub_product(R::literal(0.833_333_333_333_333_4), t236)
        .add_product(R::literal(0.833_333_333_333_333_4), t228);
    let post_omega_dot_by_plate_phi = (-(t20 * t237).add_product(t19, t238).add_product(t19, t236))
        .add_product(t20, t235);
    let post_v_y_dot_by_plate_phi = (R::literal(1.25) * t235).add_product(R::literal(1.25), t237);
    let post_v_x_dot_by_plate_phi = (R::literal(1.25) * t236).sub_product(R::literal(1.25), t238);
    let t239 = p.spring_stiffness * cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t240 = spring_damping_times_cylinder_omega * sin_cylinder_phi;
    let t241 = t240 - t239;
    let t242 = t241 * cos_cylinder_phi;
    let t243 = t241 * sin_cylinder_phi;
    let t244 = spring_damping_times_cylinder_omega * t15;
    let t245 = t244 * sin_cylinder_phi;
    let t246 = p.spring_stiffness * t15;
    let t247 = t246 * cos_cylinder_phi;
    let t248 = t239 - t240;
    let t249 = t248 * cos_cylinder_phi;
    let t250 = t248 * sin_cylinder_phi;
    let t251 = cos_cylinder_phi * t182;
    let t252 = t247 - t245 - t133 - t134 - t251;
    let t253 = cos_cylinder_phi * cylinder_omega_dot;
    let t254 = R::literal(3.333_333_333_333_333_5) * t242;
    let t255 = t254.add_product(t27, t252);
    let t256 = R::literal(3.333_333_333_333_333_5) * t243;
    let t257 = (-t256).add_product(t28, t252).sub_product(t76, t255);
    let t258 = R::literal(2_777.777_777_777_778) * t252;
    let t259 = t258.sub_product(t77, t255).sub_product(t86, t257);
    let t260 = (t146 - t253).sub_product(t25, t242).add_product(t26, t243).add_product(t29, t252)
        .add_product(t30, t249).sub_product(t31, t250).sub_product(t79, t255).sub_product(t88, t257)
        .sub_product(t95, t259);
    let t261 = R::literal(5.0) * t249;
    let t262 = t261.add_product(t96, t259).add_product(t104, t260);
    let t263 = R::literal(5.0) * t250;
    let t264 = (-t263).add_product(t97, t259).sub_product(t106, t260).sub_product(t113, t262);
    let t265 = (-(t81 * t255).add_product(t90, t257).add_product(t99, t259).add_product(t108, t260))
        .add_product(t115, t262).sub_product(t120, t264);
    let t266 = (-(t83 * t255).add_product(t92, t257).add_product(t101, t259).add_product(t110,
        t260)).add_product(t117, t262).sub_product(t122, t264).sub_product(t125, t265) * t126;
    let t267 = (t265 * t123).sub_product(t125, t266);
    let t268 = (t264 * t118).sub_product(t120, t267).sub_product(t122, t266);
    let t269 = (t262 * t111).add_product(t113, t268).sub_product(t115, t267).sub_product(t117,
        t266);
    let t270 = (t260 * t102).sub_product(t104, t269).sub_product(t106, t268).sub_product(t108, t267)
        .sub_product(t110, t266);
    let t271 = (t259 * t93).sub_product(t95, t270).sub_product(t96, t269).add_product(t97, t268)
        .sub_product(t99, t267).sub_product(t101, t266);
    let t272 = (t257 * t84).sub_product(t86, t271).sub_product(t88, t270).sub_product(t90, t267)
        .sub_product(t92, t266);
    let t273 = (t255 * t74).add_product(t76, t272).add_product(t77, t271).add_product(t79, t270)
        .add_product(t81, t267).add_product(t83, t266);
    let t274 = (-(t67 * t272).add_product(t65, t273)).add_product(t70, t267).sub_product(t73, t266);
    let t275 = (-(t55 * t273).add_product(t53, t274).add_product(t56, t272).add_product(t59, t267))
        .add_product(t61, t266);
    let t276 = (t48 * t274).add_product(t46, t275);
    let t277 = (t40 * t275).sub_product(t38, t276).add_product(t38, t274);
    let bobbin_v_y_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t266;
    let bobbin_v_x_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t267;
    let rod_omega_dot_by_cylinder_x = (t32 * t269).sub_product(R::literal(4_166.666_666_666_667),
        t271).sub_product(t33, t268);
    let rod_v_y_dot_by_cylinder_x = t263.sub_product(t31, t270).sub_product(R::literal(5.0), t268);
    let rod_v_x_dot_by_cylinder_x = t261.add_product(t30, t270).sub_product(R::literal(5.0), t269);
    let cylinder_omega_dot_by_cylinder_x = t258.sub_product(t27, t273).add_product(t28, t272)
        .add_product(R::literal(2_777.777_777_777_778), t271).add_product(t29, t270);
    let cylinder_v_y_dot_by_cylinder_x = t256.sub_product(R::literal(3.333_333_333_333_333_5), t272)
        .add_product(t26, t270);
    let cylinder_v_x_dot_by_cylinder_x = t254.sub_product(R::literal(3.333_333_333_333_333_5), t273)
        .sub_product(t25, t270);
    let plate_omega_dot_by_cylinder_x = (t22 * t274).sub_product(t21, t275).sub_product(t21, t273)
        .add_product(t22, t272).add_product(t23, t267).sub_product(t24, t266);
    let plate_v_y_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t272)
        .sub_product(R::literal(0.833_333_333_333_333_4), t274)
        .add_product(R::literal(0.833_333_333_333_333_4), t266);
    let plate_v_x_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t273)
        .sub_product(R::literal(0.833_333_333_333_333_4), t275)
        .add_product(R::literal(0.833_333_333_333_333_4), t267);
    let post_omega_dot_by_cylinder_x = (-(t20 * t276).add_product(t19, t277).add_product(t19, t275))
        .add_product(t20, t274);
    let post_v_y_dot_by_cylinder_x = (R::literal(1.25) * t274).add_product(R::literal(1.25), t276);
    let post_v_x_dot_by_cylinder_x = (R::literal(1.25) * t275).sub_product(R::literal(1.25), t277);
    let t278 = (spring_damping_times_cylinder_omega * cos_cylinder_phi)
        .add_product(p.spring_stiffness, sin_cylinder_phi);
    let t279 = t278 * cos_cylinder_phi;
    let t280 = t278 * sin_cylinder_phi;
    let t281 = t246 * sin_cylinder_phi;
    let t282 = t130.add_product(t244, cos_cylinder_phi) + t281 + t131;
    let t283 = sin_cylinder_phi * t182;
    let t284 = t282 - t283;
    let t285 = t145.add_product(sin_cylinder_phi, cylinder_omega_dot);
    let t286 = R::literal(3.333_333_333_333_333_5) * t279;
    let t287 = t286.sub_product(t27, t284);
    let t288 = R::literal(3.333_333_333_333_333_5) * t280;
    let t289 = t288.add_product(t28, t284).add_product(t76, t287);
    let t290 = R::literal(2_777.777_777_777_778) * t284;
    let t291 = t290.add_product(t77, t287).sub_product(t86, t289);
    let t292 = t25 * t279;
    let t293 = t26 * t280;
    let t294 = t30 * t279;
    let t295 = t31 * t280;
    let t296 = ((t292 - t285 - t293).add_product(t29, t284) + t294 - t295).add_product(t79, t287)
        .sub_product(t88, t289).sub_product(t95, t291);
    let t297 = R::literal(5.0) * t279;
    let t298 = t297.add_product(t96, t291).add_product(t104, t296);
    let t299 = R::literal(5.0) * t280;
    let t300 = (-t299).add_product(t97, t291).sub_product(t106, t296).sub_product(t113, t298);
    let t301 = (t81 * t287).sub_product(t90, t289).sub_product(t99, t291).sub_product(t108, t296)
        .add_product(t115, t298).sub_product(t120, t300);
    let t302 = (t83 * t287).sub_product(t92, t289).sub_product(t101, t291).sub_product(t110, t296)
        .add_product(t117, t298).sub_product(t122, t300).sub_product(t125, t301) * t126;
    let t303 = (t301 * t123).sub_product(t125, t302);
    let t304 = (t300 * t118).sub_product(t120, t303).sub_product(t122, t302);
    let t305 = (t298 * t111).add_product(t113, t304).sub_product(t115, t303).sub_product(t117,
        t302);
    let t306 = (t296 * t102).sub_product(t104, t305).sub_product(t106, t304).sub_product(t108, t303)
        .sub_product(t110, t302);
    let t307 = (t291 * t93).sub_product(t95, t306).sub_product(t96, t305).add_product(t97, t304)
        .sub_product(t99, t303).sub_product(t101, t302);
    let t308 = (t289 * t84).sub_product(t86, t307).sub_product(t88, t306).sub_product(t90, t303)
        .sub_product(t92, t302);
    let t309 = (-(t287 * t74)).add_product(t76, t308).add_product(t77, t307).add_product(t79, t306)
        .add_product(t81, t303).add_product(t83, t302);
    let t310 = (-(t67 * t308).add_product(t65, t309)).add_product(t70, t303).sub_product(t73, t302);
    let t311 = (-(t55 * t309).add_product(t53, t310).add_product(t56, t308).add_product(t59, t303))
        .add_product(t61, t302);
    let t312 = (t48 * t310).add_product(t46, t311);
    let t313 = (t40 * t311).sub_product(t38, t312).add_product(t38, t310);
    let bobbin_v_y_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t302;
    let bobbin_v_x_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t303;
    let rod_omega_dot_by_cylinder_y = (t32 * t305).sub_product(R::literal(4_166.666_666_666_667),
        t307).sub_product(t33, t304);
    let rod_v_y_dot_by_cylinder_y = t299.sub_product(t31, t306).sub_product(R::literal(5.0), t304);
    let rod_v_x_dot_by_cylinder_y = t297.add_product(t30, t306).sub_product(R::literal(5.0), t305);
    let cylinder_omega_dot_by_cylinder_y = t290.sub_product(t27, t309).add_product(t28, t308)
        .add_product(R::literal(2_777.777_777_777_778), t307).add_product(t29, t306);
    let cylinder_v_y_dot_by_cylinder_y = (-t288.add_product(R::literal(3.333_333_333_333_333_5),
        t308)).add_product(t26, t306);
    let cylinder_v_x_dot_by_cylinder_y = -t286.add_product(R::literal(3.333_333_333_333_333_5),
        t309).add_product(t25, t306);
    let plate_omega_dot_by_cylinder_y = (t22 * t310).sub_product(t21, t311).sub_product(t21, t309)
        .add_product(t22, t308).add_product(t23, t303).sub_product(t24, t302);
    let plate_v_y_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t308)
        .sub_product(R::literal(0.833_333_333_333_333_4), t310)
        .add_product(R::literal(0.833_333_333_333_333_4), t302);
    let plate_v_x_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t309)
        .sub_product(R::literal(0.833_333_333_333_333_4), t311)
        .add_product(R::literal(0.833_333_333_333_333_4), t303);
    let post_omega_dot_by_cylinder_y = (-(t20 * t312).add_product(t19, t313).add_product(t19, t311))
        .add_product(t20, t310);
    let post_v_y_dot_by_cylinder_y = (R::literal(1.25) * t310).add_product(R::literal(1.25), t312);
    let post_v_x_dot_by_cylinder_y = (R::literal(1.25) * t311).sub_product(R::literal(1.25), t313);
    let t314 = p.spring_damping * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
        .sub_product(cylinder_omega, slide).sub_product(rod_v_x_minus_cylinder_v_x,
        sin_cylinder_phi);
    let t315 = t314 * cos_cylinder_phi;
    let t316 = t131.add_product(t314, sin_cylinder_phi) + (t130 + t281);
    let t317 = t15 * t15;
    let t318 = R::literal(0.06) * cylinder_omega_squared;
    let t319 = t247 + t315 - t133 - t134 - t251;
    let t320 = t316 - t283;
    let t321 = t13 - t14;
    let t322 = (p.spring_stiffness * slide * t128).add_product(p.spring_damping * slide, slide_rate)
        .sub_product(p.spring_stiffness, t317).sub_product(t314, t15).sub_product(t4, t185)
        .sub_product(t5, t184).sub_product(t321, t182);
    let t323 = t133 + t134 - t247 - t315 + t251;
    let t324 = t283 - t316;
    let t325 = R::literal(3.333_333_333_333_333_5) * t319;
    let t326 = ((t318 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t325)
        .sub_product(t27, t322);
    let t327 = R::literal(3.333_333_333_333_333_5) * t320;
    let t328 = (-((t318 * cos_cylinder_phi).add_product(t5, cylinder_omega_dot) + t327))
        .add_product(t28, t322).add_product(t76, t326);
    let t329 = R::literal(2_777.777_777_777_778) * t322;
    let t330 = t329.add_product(t77, t326).sub_product(t86, t328);
    let t331 = (cylinder_omega * (t147 * sin_cylinder_phi).add_product(t152, cos_cylinder_phi)
        .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
        .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi).sub_product(t148,
        cos_cylinder_phi).sub_product(t151, sin_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi)).sub_product(cos_cylinder_phi,
        cylinder_v_x_dot).sub_product(sin_cylinder_phi, cylinder_v_y_dot).sub_product(t321,
        cylinder_omega_dot).add_product(cos_cylinder_phi, rod_v_x_dot)
        .sub_product(sin_cylinder_phi, t175.add_product(t31, t182).add_product(R::literal(5.0),
        t180)).sub_product(t25, t319).add_product(t26, t320).add_product(t29, t322)
        .add_product(t30, t323).sub_product(t31, t324).add_product(t79, t326).sub_product(t88, t328)
        .sub_product(t95, t330);
    let t332 = R::literal(5.0) * t323;
    let t333 = t332.add_product(t96, t330).add_product(t104, t331);
    let t334 = R::literal(5.0) * t324;
    let t335 = (-t334).add_product(t97, t330).sub_product(t106, t331).sub_product(t113, t333);
    let t336 = (t81 * t326).sub_product(t90, t328).sub_product(t99, t330).sub_product(t108, t331)
        .add_product(t115, t333).sub_product(t120, t335);
    let t337 = (t83 * t326).sub_product(t92, t328).sub_product(t101, t330).sub_product(t110, t331)
        .add_product(t117, t333).sub_product(t122, t335).sub_product(t125, t336) * t126;
    let t338 = (t336 * t123).sub_product(t125, t337);
    let t339 = (t335 * t118).sub_product(t120, t338).sub_product(t122, t337);
    let t340 = (t333 * t111).add_product(t113, t339).sub_product(t115, t338).sub_product(t117,
        t337);
    let t341 = (t331 * t102).sub_product(t104, t340).sub_product(t106, t339).sub_product(t108, t338)
        .sub_product(t110, t337);
    let t342 = (t330 * t93).sub_product(t95, t341).sub_product(t96, t340).add_product(t97, t339)
        .sub_product(t99, t338).sub_product(t101, t337);
    let t343 = (t328 * t84).sub_product(t86, t342).sub_product(t88, t341).sub_product(t90, t338)
        .sub_product(t92, t337);
    let t344 = (-(t326 * t74)).add_product(t76, t343).add_product(t77, t342).add_product(t79, t341)
        .add_product(t81, t338).add_product(t83, t337);
    let t345 = (-(t67 * t343).add_product(t65, t344)).add_product(t70, t338).sub_product(t73, t337);
    let t346 = (-(t55 * t344).add_product(t53, t345).add_product(t56, t343).add_product(t59, t338))
        .add_product(t61, t337);
    let t347 = (t48 * t345).add_product(t46, t346);
    let t348 = (t40 * t346).sub_product(t38, t347).add_product(t38, t345);
    let bobbin_v_y_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t337;
    let bobbin_v_x_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t338;
    let rod_omega_dot_by_cylinder_phi = (t32 * t340).sub_product(R::literal(4_166.666_666_666_667),
        t342).sub_product(t33, t339);
    let rod_v_y_dot_by_cylinder_phi = t334.sub_product(t31, t341).sub_product(R::literal(5.0),
        t339);
    let rod_v_x_dot_by_cylinder_phi = t332.add_product(t30, t341).sub_product(R::literal(5.0),
        t340);
    let cylinder_omega_dot_by_cylinder_phi = t329.sub_product(t27, t344).add_product(t28, t343)
        .add_product(R::literal(2_777.777_777_777_778), t342).add_product(t29, t341);
    let cylinder_v_y_dot_by_cylinder_phi = t327.sub_product(R::literal(3.333_333_333_333_333_5),
        t343).add_product(t26, t341);
    let cylinder_v_x_dot_by_cylinder_phi = t325.sub_product(R::literal(3.333_333_333_333_333_5),
        t344).sub_product(t25, t341);
    let plate_omega_dot_by_cylinder_phi = (t22 * t345).sub_product(t21, t346).sub_product(t21, t344)
        .add_product(t22, t343).add_product(t23, t338).sub_product(t24, t337);
    let plate_v_y_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t343)
        .sub_product(R::literal(0.833_333_333_333_333_4), t345)
        .add_product(R::literal(0.833_333_333_333_333_4), t337);
    let plate_v_x_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t344)
        .sub_product(R::literal(0.833_333_333_333_333_4), t346)
        .add_product(R::literal(0.833_333_333_333_333_4), t338);
    let post_omega_dot_by_cylinder_phi = (-(t20 * t347).add_product(t19, t348).add_product(t19,
        t346)).add_product(t20, t345);
    let post_v_y_dot_by_cylinder_phi = (R::literal(1.25) * t345).add_product(R::literal(1.25),
        t347);
    let post_v_x_dot_by_cylinder_phi = (R::literal(1.25) * t346).sub_product(R::literal(1.25),
        t348);
    let t349 = t245 + t133 + t134 - t247 + t251;
    let t350 = R::literal(3.333_333_333_333_333_5) * t249;
    let t351 = t350.add_product(t27, t349);
    let t352 = R::literal(3.333_333_333_333_333_5) * t250;
    let t353 = (-t352).add_product(t28, t349).sub_product(t76, t351);
    let t354 = R::literal(2_777.777_777_777_778) * t349;
    let t355 = t354.sub_product(t77, t351).sub_product(t86, t353);
    let t356 = (t253 - t146).sub_product(t25, t249).add_product(t26, t250).add_product(t29, t349)
        .add_product(t30, t242).sub_product(t31, t243).sub_product(t79, t351).sub_product(t88, t353)
        .sub_product(t95, t355);
    let t357 = R::literal(5.0) * t242;
    let t358 = t357.add_product(t96, t355).add_product(t104, t356);
    let t359 = R::literal(5.0) * t243;
    let t360 = (-t359).add_product(t97, t355).sub_product(t106, t356).sub_product(t113, t358);
    let t361 = (-(t81 * t351).add_product(t90, t353).add_product(t99, t355).add_product(t108, t356))
        .add_product(t115, t358).sub_product(t120, t360);
    let t362 = (-(t83 * t351).add_product(t92, t353).add_product(t101, t355).add_product(t110,
        t356)).add_product(t117, t358).sub_product(t122, t360).sub_product(t125, t361) * t126;
    let t363 = (t361 * t123).sub_product(t125, t362);
    let t364 = (t360 * t118).sub_product(t120, t363).sub_product(t122, t362);
    let t365 = (t358 * t111).add_product(t113, t364).sub_product(t115, t363).sub_product(t117,
        t362);
    let t366 = (t356 * t102).sub_product(t104, t365).sub_product(t106, t364).sub_product(t108, t363)
        .sub_product(t110, t362);
    let t367 = (t355 * t93).sub_product(t95, t366).sub_product(t96, t365).add_product(t97, t364)
        .sub_product(t99, t363).sub_product(t101, t362);
    let t368 = (t353 * t84).sub_product(t86, t367).sub_product(t88, t366).sub_product(t90, t363)
        .sub_product(t92, t362);
    let t369 = (t351 * t74).add_product(t76, t368).add_product(t77, t367).add_product(t79, t366)
        .add_product(t81, t363).add_product(t83, t362);
    let t370 = (-(t67 * t368).add_product(t65, t369)).add_product(t70, t363).sub_product(t73, t362);
    let t371 = (-(t55 * t369).add_product(t53, t370).add_product(t56, t368).add_product(t59, t363))
        .add_product(t61, t362);
    let t372 = (t48 * t370).add_product(t46, t371);
    let t373 = (t40 * t371).sub_product(t38, t372).add_product(t38, t370);
    let bobbin_v_y_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t362;
    let bobbin_v_x_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t363;
    let rod_omega_dot_by_rod_x = (t32 * t365).sub_product(R::literal(4_166.666_666_666_667), t367)
        .sub_product(t33, t364);
    let rod_v_y_dot_by_rod_x = t359.sub_product(t31, t366).sub_product(R::literal(5.0), t364);
    let rod_v_x_dot_by_rod_x = t357.add_product(t30, t366).sub_product(R::literal(5.0), t365);
    let cylinder_omega_dot_by_rod_x = t354.sub_product(t27, t369).add_product(t28, t368)
        .add_product(R::literal(2_777.777_777_777_778), t367).add_product(t29, t366);
    let cylinder_v_y_dot_by_rod_x = t352.sub_product(R::literal(3.333_333_333_333_333_5), t368)
        .add_product(t26, t366);
    let cylinder_v_x_dot_by_rod_x = t350.sub_product(R::literal(3.333_333_333_333_333_5), t369)
        .sub_product(t25, t366);
    let plate_omega_dot_by_rod_x = (t22 * t370).sub_product(t21, t371).sub_product(t21, t369)
        .add_product(t22, t368).add_product(t23, t363).sub_product(t24, t362);
    let plate_v_y_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t368)
        .sub_product(R::literal(0.833_333_333_333_333_4), t370)
        .add_product(R::literal(0.833_333_333_333_333_4), t362);
    let plate_v_x_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t369)
        .sub_product(R::literal(0.833_333_333_333_333_4), t371)
        .add_product(R::literal(0.833_333_333_333_333_4), t363);
    let post_omega_dot_by_rod_x = (-(t20 * t372).add_product(t19, t373).add_product(t19, t371))
        .add_product(t20, t370);
    let post_v_y_dot_by_rod_x = (R::literal(1.25) * t370).add_product(R::literal(1.25), t372);
    let post_v_x_dot_by_rod_x = (R::literal(1.25) * t371).sub_product(R::literal(1.25), t373);
    let t374 = t283 - t282;
    let t375 = t286.add_product(t27, t374);
    let t376 = (-t288).add_product(t28, t374).sub_product(t76, t375);
    let t377 = R::literal(2_777.777_777_777_778) * t374;
    let t378 = t377.sub_product(t77, t375).sub_product(t86, t376);
    let t379 = ((t285 - t292 + t293).add_product(t29, t374) - t294 + t295).sub_product(t79, t375)
        .sub_product(t88, t376).sub_product(t95, t378);
    let t380 = t297.sub_product(t96, t378).sub_product(t104, t379);
    let t381 = t299.add_product(t97, t378).sub_product(t106, t379).add_product(t113, t380);
    let t382 = (t81 * t375).add_product(t90, t376).add_product(t99, t378).add_product(t108, t379)
        .add_product(t115, t380).add_product(t120, t381);
    let t383 = (-(t83 * t375).add_product(t92, t376).add_product(t101, t378).add_product(t110, t379)
        .add_product(t117, t380).add_product(t122, t381)).add_product(t125, t382) * t126;
    let t384 = (t382 * t123).add_product(t125, t383);
    let t385 = (t381 * t118).add_product(t120, t384).sub_product(t122, t383);
    let t386 = (-(t380 * t111)).add_product(t113, t385).add_product(t115, t384).sub_product(t117,
        t383);
    let t387 = (t379 * t102).sub_product(t104, t386).sub_product(t106, t385).add_product(t108, t384)
        .sub_product(t110, t383);
    let t388 = (t378 * t93).sub_product(t95, t387).sub_product(t96, t386).add_product(t97, t385)
        .add_product(t99, t384).sub_product(t101, t383);
    let t389 = (t376 * t84).sub_product(t86, t388).sub_product(t88, t387).add_product(t90, t384)
        .sub_product(t92, t383);
    let t390 = (t375 * t74).add_product(t76, t389).add_product(t77, t388).add_product(t79, t387)
        .sub_product(t81, t384).add_product(t83, t383);
    let t391 = (t67 * t389).add_product(t65, t390).add_product(t70, t384).add_product(t73, t383);
    let t392 = (-(t55 * t390)).add_product(t53, t391).sub_product(t56, t389).add_product(t59, t384)
        .add_product(t61, t383);
    let t393 = (t48 * t391).sub_product(t46, t392);
    let t394 = (t40 * t392).add_product(t38, t393).sub_product(t38, t391);
    let bobbin_v_y_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t383;
    let bobbin_v_x_dot_by_rod_y = R::literal(1.428_571_428_571_428_6) * t384;
    let rod_omega_dot_by_rod_y = (t32 * t386).sub_product(R::literal(4_166.666_666_666_667), t388)
        .sub_product(t33, t385);
    let rod_v_y_dot_by_rod_y = -t299.add_product(t31, t387).add_product(R::literal(5.0), t385);
    let rod_v_x_dot_by_rod_y = (-t297).add_product(t30, t387).sub_product(R::literal(5.0), t386);
    let cylinder_omega_dot_by_rod_y = t377.sub_product(t27, t390).add_product(t28, t389)
        .add_product(R::literal(2_777.777_777_777_778), t388).add_product(t29, t387);
    let cylinder_v_y_dot_by_rod_y = t288.sub_product(R::literal(3.333_333_333_333_333_5), t389)
        .add_product(t26, t387);
    let cylinder_v_x_dot_by_rod_y = t286.sub_product(R::literal(3.333_333_333_333_333_5), t390)
        .sub_product(t25, t387);
    let plate_omega_dot_by_rod_y = (-(t22 * t391).add_product(t21, t392).add_product(t21, t390))
        .add_product(t22, t389).sub_product(t23, t384).sub_product(t24, t383);
    let plate_v_y_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t389)
        .add_product(R::literal(0.833_333_333_333_333_4), t391)
        .add_product(R::literal(0.833_333_333_333_333_4), t383);
    let plate_v_x_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t390)
        .sub_product(R::literal(0.833_333_333_333_333_4), t392)
        .sub_product(R::literal(0.833_333_333_333_333_4), t384);
    let post_omega_dot_by_rod_y = (t20 * t393).sub_product(t19, t394).sub_product(t19, t392)
        .sub_product(t20, t391);
    let post_v_y_dot_by_rod_y = -(R::literal(1.25) * t391).add_product(R::literal(1.25), t393);
    let post_v_x_dot_by_rod_y = (R::literal(1.25) * t392).sub_product(R::literal(1.25), t394);
    let t395 = (t7 * t180).add_product(t6, t181);
    let t396 = R::literal(4_166.666_666_666_667) * t395;
    let t397 = t95 * t396;
    let t398 = (-t157).add_product(t6, rod_omega_dot).add_product(t32, t395).add_product(t96, t396)
        .sub_product(t104, t397);
    let t399 = t156.add_product(t7, rod_omega_dot).sub_product(t33, t395).sub_product(t97, t396)
        .sub_product(t106, t397).add_product(t113, t398);
    let t400 = (t99 * t396).sub_product(t108, t397).sub_product(t115, t398).sub_product(t120, t399);
    let t401 = (t101 * t396).sub_product(t110, t397).sub_product(t117, t398).sub_product(t122, t399)
        .sub_product(t125, t400) * t126;
    let t402 = (t400 * t123).sub_product(t125, t401);
    let t403 = (t399 * t118).sub_product(t120, t402).sub_product(t122, t401);
    let t404 = (-(t398 * t111)).add_product(t113, t403).sub_product(t115, t402).sub_product(t117,
        t401);
    let t405 = (t397 * t102).sub_product(t104, t404).sub_product(t106, t403).sub_product(t108, t402)
        .sub_product(t110, t401);
    let t406 = (-(t396 * t93).add_product(t95, t405).add_product(t96, t404)).add_product(t97, t403)
        .sub_product(t99, t402).sub_product(t101, t401);
    let t407 = (t88 * t405).add_product(t86, t406).add_product(t90, t402).add_product(t92, t401);
    let t408 = (t77 * t406).sub_product(t76, t407).add_product(t79, t405).add_product(t81, t402)
        .add_product(t83, t401);
    let t409 = (t67 * t407).sub_product(t65, t408).add_product(t70, t402).sub_product(t73, t401);
    let t410 = (-(t55 * t408).add_product(t53, t409)).add_product(t56, t407).sub_product(t59, t402)
        .add_product(t61, t401);
    let t411 = (t48 * t409).add_product(t46, t410);
    let t412 = (t40 * t410).sub_product(t38, t411).add_product(t38, t409);
    let bobbin_v_y_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t401;
    let bobbin_v_x_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t402;
    let rod_omega_dot_by_rod_phi = t396.sub_product(R::literal(4_166.666_666_666_667), t406)
        .add_product(t32, t404).sub_product(t33, t403);
    let rod_v_y_dot_by_rod_phi = -(R::literal(5.0) * t403).add_product(t31, t405);
    let rod_v_x_dot_by_rod_phi = (R::literal(-5.0) * t404).add_product(t30, t405);
    let cylinder_omega_dot_by_rod_phi = (-(t28 * t407).add_product(t27, t408))
        .add_product(R::literal(2_777.777_777_777_778), t406).add_product(t29, t405);
    let cylinder_v_y_dot_by_rod_phi = (t26 * t405).add_product(R::literal(3.333_333_333_333_333_5),
        t407);
    let cylinder_v_x_dot_by_rod_phi = -(t25 * t405)
        .add_product(R::literal(3.333_333_333_333_333_5), t408);
    let plate_omega_dot_by_rod_phi = (t22 * t409).sub_product(t21, t410).sub_product(t21, t408)
        .sub_product(t22, t407).add_product(t23, t402).sub_product(t24, t401);
    let plate_v_y_dot_by_rod_phi = (-(R::literal(0.833_333_333_333_333_4) * t407)
        .add_product(R::literal(0.833_333_333_333_333_4), t409))
        .add_product(R::literal(0.833_333_333_333_333_4), t401);
    let plate_v_x_dot_by_rod_phi = (R::literal(0.833_333_333_333_333_4) * t408)
        .sub_product(R::literal(0.833_333_333_333_333_4), t410)
        .add_product(R::literal(0.833_333_333_333_333_4), t402);
    let post_omega_dot_by_rod_phi = (-(t20 * t411).add_product(t19, t412).add_product(t19, t410))
        .add_product(t20, t409);
    let post_v_y_dot_by_rod_phi = (R::literal(1.25) * t409).add_product(R::literal(1.25), t411);
    let post_v_x_dot_by_rod_phi = (R::literal(1.25) * t410).sub_product(R::literal(1.25), t412);
    let between_squared = between * between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t413 = contact_stiffness_times_contact_gap / between;
    let t414 = contact_damping_times_contact_rate / between;
    let between_squared_times_between = between_squared * between;
    let t415 = c.t0 * contact_rate;
    let t416 = t415 * t9 * t11 / between_squared_times_between;
    let t417 = t138 * t11 / between_squared_times_between;
    let t418 = p.contact_stiffness * t9 * t11 / between_squared;
    let t419 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t415 * t10 / between_squared_times_between
        + contact_stiffness_times_contact_gap * t10 / between_squared_times_between
        - contact_damping_times_bobbin_v_x * t9 / between_squared - t413 - p.contact_stiffness
        * t10 / between_squared - t414);
    let t420 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t416 - contact_damping_times_bobbin_v_x * t11
        / between_squared - (t418 - t417));
    let t421 = (-t420).add_product(t125, t419) * t126;
    let t422 = (t419 * t123).add_product(t125, t421);
    let t423 = (-(t122 * t421)).add_product(t120, t422);
    let t424 = (t115 * t422).add_product(t113, t423).sub_product(t117, t421);
    let t425 = (-(t106 * t423).add_product(t104, t424)).add_product(t108, t422).sub_product(t110,
        t421);
    let t426 = (-(t96 * t424).add_product(t95, t425)).add_product(t97, t423).add_product(t99, t422)
        .sub_product(t101, t421);
    let t427 = (-(t88 * t425).add_product(t86, t426)).add_product(t90, t422).sub_product(t92, t421);
    let t428 = (t77 * t426).add_product(t76, t427).add_product(t79, t425).sub_product(t81, t422)
        .add_product(t83, t421);
    let t429 = (t67 * t427).add_product(t65, t428).add_product(t70, t422).add_product(t73, t421);
    let t430 = (-(t55 * t428)).add_product(t53, t429).sub_product(t56, t427).add_product(t59, t422)
        .add_product(t61, t421);
    let t431 = (t48 * t429).sub_product(t46, t430);
    let t432 = (t40 * t430).add_product(t38, t431).sub_product(t38, t429);
    let bobbin_v_y_dot_by_bobbin_x = t420.sub_product(R::literal(1.428_571_428_571_428_6), t421);
    let bobbin_v_x_dot_by_bobbin_x = t419.add_product(R::literal(1.428_571_428_571_428_6), t422);
    let rod_omega_dot_by_bobbin_x = (t32 * t424).sub_product(R::literal(4_166.666_666_666_667),
        t426).sub_product(t33, t423);
    let rod_v_y_dot_by_bobbin_x = -(R::literal(5.0) * t423).add_product(t31, t425);
    let rod_v_x_dot_by_bobbin_x = (R::literal(-5.0) * t424).add_product(t30, t425);
    let cylinder_omega_dot_by_bobbin_x = (t28 * t427).sub_product(t27, t428)
        .add_product(R::literal(2_777.777_777_777_778), t426).add_product(t29, t425);
    let cylinder_v_y_dot_by_bobbin_x = (t26 * t425)
        .sub_product(R::literal(3.333_333_333_333_333_5), t427);
    let cylinder_v_x_dot_by_bobbin_x = -(t25 * t425)
        .add_product(R::literal(3.333_333_333_333_333_5), t428);
    let plate_omega_dot_by_bobbin_x = (-(t22 * t429).add_product(t21, t430).add_product(t21, t428))
        .add_product(t22, t427).sub_product(t23, t422).sub_product(t24, t421);
    let plate_v_y_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t427)
        .add_product(R::literal(0.833_333_333_333_333_4), t429)
        .add_product(R::literal(0.833_333_333_333_333_4), t421);
    let plate_v_x_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t428)
        .sub_product(R::literal(0.833_333_333_333_333_4), t430)
        .sub_product(R::literal(0.833_333_333_333_333_4), t422);
    let post_omega_dot_by_bobbin_x = (t20 * t431).sub_product(t19, t432).sub_product(t19, t430)
        .sub_product(t20, t429);
    let post_v_y_dot_by_bobbin_x = -(R::literal(1.25) * t429).add_product(R::literal(1.25), t431);
    let post_v_x_dot_by_bobbin_x = (R::literal(1.25) * t430).sub_product(R::literal(1.25), t432);
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t433 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t416 + t417 - contact_damping_times_bobbin_v_y * t9
        / between_squared - t418);
    let t434 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t415 * t12 / between_squared_times_between
        - contact_damping_times_bobbin_v_y * t11 / between_squared - t414
        - (t413 + p.contact_stiffness * t12 / between_squared - contact_stiffness_times_contact_gap
        * t12 / between_squared_times_between));
    let t435 = (-t434).add_product(t125, t433) * t126;
    let t436 = (t433 * t123).add_product(t125, t435);
    let t437 = (-(t122 * t435)).add_product(t120, t436);
    let t438 = (t115 * t436).add_product(t113, t437).sub_product(t117, t435);
    let t439 = (-(t106 * t437).add_product(t104, t438)).add_product(t108, t436).sub_product(t110,
        t435);
    let t440 = (-(t96 * t438).add_product(t95, t439)).add_product(t97, t437).add_product(t99, t436)
        .sub_product(t101, t435);
    let t441 = (-(t88 * t439).add_product(t86, t440)).add_product(t90, t436).sub_product(t92, t435);
    let t442 = (t77 * t440).add_product(t76, t441).add_product(t79, t439).sub_product(t81, t436)
        .add_product(t83, t435);
    let t443 = (t67 * t441).add_product(t65, t442).add_product(t70, t436).add_product(t73, t435);
    let t444 = (-(t55 * t442)).add_product(t53, t443).sub_product(t56, t441).add_product(t59, t436)
        .add_product(t61, t435);
    let t445 = (t48 * t443).sub_product(t46, t444);
    let t446 = (t40 * t444).add_product(t38, t445).sub_product(t38, t443);
    let bobbin_v_y_dot_by_bobbin_y = t434.sub_product(R::literal(1.428_571_428_571_428_6), t435);
    let bobbin_v_x_dot_by_bobbin_y = t433.add_product(R::literal(1.428_571_428_571_428_6), t436);
    let rod_omega_dot_by_bobbin_y = (t32 * t438).sub_product(R::literal(4_166.666_666_666_667),
        t440).sub_product(t33, t437);
    let rod_v_y_dot_by_bobbin_y = -(R::literal(5.0) * t437).add_product(t31, t439);
    let rod_v_x_dot_by_bobbin_y = (R::literal(-5.0) * t438).add_product(t30, t439);
    let cylinder_omega_dot_by_bobbin_y = (t28 * t441).sub_product(t27, t442)
        .add_product(R::literal(2_777.777_777_777_778), t440).add_product(t29, t439);
    let cylinder_v_y_dot_by_bobbin_y = (t26 * t439)
        .sub_product(R::literal(3.333_333_333_333_333_5), t441);
    let cylinder_v_x_dot_by_bobbin_y = -(t25 * t439)
        .add_product(R::literal(3.333_333_333_333_333_5), t442);
    let plate_omega_dot_by_bobbin_y = (-(t22 * t443).add_product(t21, t444).add_product(t21, t442))
        .add_product(t22, t441).sub_product(t23, t436).sub_product(t24, t435);
    let plate_v_y_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t441)
        .add_product(R::literal(0.833_333_333_333_333_4), t443)
        .add_product(R::literal(0.833_333_333_333_333_4), t435);
    let plate_v_x_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t442)
        .sub_product(R::literal(0.833_333_333_333_333_4), t444)
        .sub_product(R::literal(0.833_333_333_333_333_4), t436);
    let post_omega_dot_by_bobbin_y = (t20 * t445).sub_product(t19, t446).sub_product(t19, t444)
        .sub_product(t20, t443);
    let post_v_y_dot_by_bobbin_y = -(R::literal(1.25) * t443).add_product(R::literal(1.25), t445);
    let post_v_x_dot_by_bobbin_y = (R::literal(1.25) * t444).sub_product(R::literal(1.25), t446);
    let t447 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(-1500.0)
        * t190);
    let t448 = R::literal(0.2) * post_omega;
    let t449 = (t448 * cos_post_phi).add_product(t19, t447);
    let t450 = (-(t448 * sin_post_phi)).add_product(t20, t447).sub_product(t38, t449);
    let t451 = t449.add_product(t40, t449).add_product(t46, t450);
    let t452 = t450.sub_product(t48, t450).add_product(t53, t451);
    let t453 = (t55 * t451).sub_product(t65, t452);
    let t454 = (t56 * t451).sub_product(t67, t452).add_product(t76, t453);
    let t455 = (t77 * t453).sub_product(t86, t454);
    let t456 = (t79 * t453).sub_product(t88, t454).sub_product(t95, t455);
    let t457 = (t96 * t455).add_product(t104, t456);
    let t458 = (t97 * t455).sub_product(t106, t456).sub_product(t113, t457);
    let t459 = (t59 * t451).add_product(t70, t452).add_product(t81, t453).sub_product(t90, t454)
        .sub_product(t99, t455).sub_product(t108, t456).add_product(t115, t457).sub_product(t120,
        t458);
    let t460 = (-(t61 * t451).add_product(t73, t452)).add_product(t83, t453).sub_product(t92, t454)
        .sub_product(t101, t455).sub_product(t110, t456).add_product(t117, t457).sub_product(t122,
        t458).sub_product(t125, t459) * t126;
    let t461 = (t459 * t123).sub_product(t125, t460);
    let t462 = (t458 * t118).sub_product(t120, t461).sub_product(t122, t460);
    let t463 = (t457 * t111).add_product(t113, t462).sub_product(t115, t461).sub_product(t117,
        t460);
    let t464 = (t456 * t102).sub_product(t104, t463).sub_product(t106, t462).sub_product(t108, t461)
        .sub_product(t110, t460);
    let t465 = (t455 * t93).sub_product(t95, t464).sub_product(t96, t463).add_product(t97, t462)
        .sub_product(t99, t461).sub_product(t101, t460);
    let t466 = (t454 * t84).sub_product(t86, t465).sub_product(t88, t464).sub_product(t90, t461)
        .sub_product(t92, t460);
    let t467 = (-(t453 * t74)).add_product(t76, t466).add_product(t77, t465).add_product(t79, t464)
        .add_product(t81, t461).add_product(t83, t460);
    let t468 = (t452 * t63).sub_product(t65, t467).sub_product(t67, t466).add_product(t70, t461)
        .sub_product(t73, t460);
    let t469 = (-(t451 * t50).add_product(t53, t468).add_product(t55, t467).add_product(t56, t466)
        .add_product(t59, t461)).add_product(t61, t460);
    let t470 = (t450 * t44).sub_product(t46, t469).sub_product(t48, t468);
    let t471 = (t449 * t36).add_product(t38, t470).add_product(t40, t469).add_product(t38, t468);
    let bobbin_v_y_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t460;
    let bobbin_v_x_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t461;
    let rod_omega_dot_by_post_omega = (t32 * t463).sub_product(R::literal(4_166.666_666_666_667),
        t465).sub_product(t33, t462);
    let rod_v_y_dot_by_post_omega = -(R::literal(5.0) * t462).add_product(t31, t464);
    let rod_v_x_dot_by_post_omega = (R::literal(-5.0) * t463).add_product(t30, t464);
    let cylinder_omega_dot_by_post_omega = (t28 * t466).sub_product(t27, t467)
        .add_product(R::literal(2_777.777_777_777_778), t465).add_product(t29, t464);
    let cylinder_v_y_dot_by_post_omega = (t26 * t464)
        .sub_product(R::literal(3.333_333_333_333_333_5), t466);
    let cylinder_v_x_dot_by_post_omega = -(t25 * t464)
        .add_product(R::literal(3.333_333_333_333_333_5), t467);
    let plate_omega_dot_by_post_omega = (t22 * t468).sub_product(t21, t469).sub_product(t21, t467)
        .add_product(t22, t466).add_product(t23, t461).sub_product(t24, t460);
    let plate_v_y_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t466)
        .sub_product(R::literal(0.833_333_333_333_333_4), t468)
        .add_product(R::literal(0.833_333_333_333_333_4), t460);
    let plate_v_x_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t467)
        .sub_product(R::literal(0.833_333_333_333_333_4), t469)
        .add_product(R::literal(0.833_333_333_333_333_4), t461);
    let post_omega_dot_by_post_omega = (t447 * R::literal(370.370_370_370_370_3)).sub_product(t19,
        t471).add_product(t20, t470).sub_product(t19, t469).add_product(t20, t468);
    let post_v_y_dot_by_post_omega = (R::literal(1.25) * t468).sub_product(R::literal(1.25), t470);
    let post_v_x_dot_by_post_omega = (R::literal(1.25) * t469).sub_product(R::literal(1.25), t471);
    let t472 = R::literal(0.12) * plate_omega;
    let t473 = t472 * cos_plate_phi;
    let t474 = t472 * sin_plate_phi;
    let t475 = (-t474).add_product(t53, t473);
    let t476 = (-t473).add_product(t55, t473).sub_product(t65, t475);
    let t477 = (-t474).add_product(t56, t473).sub_product(t67, t475).add_product(t76, t476);
    let t478 = (t77 * t476).sub_product(t86, t477);
    let t479 = (t79 * t476).sub_product(t88, t477).sub_product(t95, t478);
    let t480 = (t96 * t478).add_product(t104, t479);
    let t481 = (t97 * t478).sub_product(t106, t479).sub_product(t113, t480);
    let t482 = (plate_omega * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2),
        sin_plate_phi)).add_product(t59, t473).add_product(t70, t475).add_product(t81, t476)
        .sub_product(t90, t477).sub_product(t99, t478).sub_product(t108, t479).add_product(t115,
        t480).sub_product(t120, t481);
    let t483 = (plate_omega * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2),
        cos_plate_phi)).sub_product(t61, t473).sub_product(t73, t475).add_product(t83, t476)
        .sub_product(t92, t477).sub_product(t101, t478).sub_product(t110, t479).add_product(t117,
        t480).sub_product(t122, t481).sub_product(t125, t482) * t126;
    let t484 = (t482 * t123).sub_product(t125, t483);
    let t485 = (t481 * t118).sub_product(t120, t484).sub_product(t122, t483);
    let t486 = (t480 * t111).add_product(t113, t485).sub_product(t115, t484).sub_product(t117,
        t483);
    let t487 = (t479 * t102).sub_product(t104, t486).sub_product(t106, t485).sub_product(t108, t484)
        .sub_product(t110, t483);
    let t488 = (t478 * t93).sub_product(t95, t487).sub_product(t96, t486).add_product(t97, t485)
        .sub_product(t99, t484).sub_product(t101, t483);
    let t489 = (t477 * t84).sub_product(t86, t488).sub_product(t88, t487).sub_product(t90, t484)
        .sub_product(t92, t483);
    let t490 = (-(t476 * t74)).add_product(t76, t489).add_product(t77, t488).add_product(t79, t487)
        .add_product(t81, t484).add_product(t83, t483);
    let t491 = (t475 * t63).sub_product(t65, t490).sub_product(t67, t489).add_product(t70, t484)
        .sub_product(t73, t483);
    let t492 = (-(t473 * t50).add_product(t53, t491).add_product(t55, t490).add_product(t56, t489)
        .add_product(t59, t484)).add_product(t61, t483);
    let t493 = (t48 * t491).add_product(t46, t492);
    let t494 = (t40 * t492).sub_product(t38, t493).add_product(t38, t491);
    let bobbin_v_y_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t483;
    let bobbin_v_x_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t484;
    let rod_omega_dot_by_plate_omega = (t32 * t486).sub_product(R::literal(4_166.666_666_666_667),
        t488).sub_product(t33, t485);
    let rod_v_y_dot_by_plate_omega = -(R::literal(5.0) * t485).add_product(t31, t487);
    let rod_v_x_dot_by_plate_omega = (R::literal(-5.0) * t486).add_product(t30, t487);
    let cylinder_omega_dot_by_plate_omega = (t28 * t489).sub_product(t27, t490)
        .add_product(R::literal(2_777.777_777_777_778), t488).add_product(t29, t487);
    let cylinder_v_y_dot_by_plate_omega = (t26 * t487)
        .sub_product(R::literal(3.333_333_333_333_333_5), t489);
    let cylinder_v_x_dot_by_plate_omega = -(t25 * t487)
        .add_product(R::literal(3.333_333_333_333_333_5), t490);
    let plate_omega_dot_by_plate_omega = (t22 * t491).sub_product(t21, t492).sub_product(t21, t490)
        .add_product(t22, t489).add_product(t23, t484).sub_product(t24, t483);
    let plate_v_y_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t489)
        .sub_product(R::literal(0.833_333_333_333_333_4), t491)
        .add_product(R::literal(0.833_333_333_333_333_4), t483);
    let plate_v_x_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t490)
        .sub_product(R::literal(0.833_333_333_333_333_4), t492)
        .add_product(R::literal(0.833_333_333_333_333_4), t484);
    let post_omega_dot_by_plate_omega = (-(t20 * t493).add_product(t19, t494).add_product(t19,
        t492)).add_product(t20, t491);
    let post_v_y_dot_by_plate_omega = (R::literal(1.25) * t491).add_product(R::literal(1.25), t493);
    let post_v_x_dot_by_plate_omega = (R::literal(1.25) * t492).sub_product(R::literal(1.25), t494);
    let t495 = p.spring_damping * (cos_cylinder_phi * cos_cylinder_phi);
    let t496 = p.spring_damping * sin_cylinder_phi * cos_cylinder_phi;
    let t497 = p.spring_damping * t15;
    let t498 = t497 * cos_cylinder_phi;
    let t499 = R::literal(2.0) * cylinder_omega;
    let t500 = t499 * cos_cylinder_phi;
    let t501 = R::literal(3.333_333_333_333_333_5) * t495;
    let t502 = t27 * t498;
    let t503 = t501 - t502;
    let t504 = R::literal(3.333_333_333_333_333_5) * t496;
    let t505 = t504.add_product(t28, t498);
    let t506 = t505.add_product(t76, t503);
    let t507 = R::literal(2_777.777_777_777_778) * t498;
    let t508 = t507.add_product(t77, t503).sub_product(t86, t506);
    let t509 = t25 * t495;
    let t510 = t26 * t496;
    let t511 = t29 * t498;
    let t512 = t30 * t495;
    let t513 = t31 * t496;
    let t514 = (t509 - t500 - t510 + t511 + t512 - t513).add_product(t79, t503).sub_product(t88,
        t506).sub_product(t95, t508);
    let t515 = R::literal(5.0) * t495;
    let t516 = t515.add_product(t96, t508).add_product(t104, t514);
    let t517 = R::literal(5.0) * t496;
    let t518 = (-t517).add_product(t97, t508).sub_product(t106, t514).sub_product(t113, t516);
    let t519 = (t81 * t503).sub_product(t90, t506).sub_product(t99, t508).sub_product(t108, t514)
        .add_product(t115, t516).sub_product(t120, t518);
    let t520 = (t83 * t503).sub_product(t92, t506).sub_product(t101, t508).sub_product(t110, t514)
        .add_product(t117, t516).sub_product(t122, t518).sub_product(t125, t519) * t126;
    let t521 = (t519 * t123).sub_product(t125, t520);
    let t522 = (t518 * t118).sub_product(t120, t521).sub_product(t122, t520);
    let t523 = (t516 * t111).add_product(t113, t522).sub_product(t115, t521).sub_product(t117,
        t520);
    let t524 = (t514 * t102).sub_product(t104, t523).sub_product(t106, t522).sub_product(t108, t521)
        .sub_product(t110, t520);
    let t525 = (t508 * t93).sub_product(t95, t524).sub_product(t96, t523).add_product(t97, t522)
        .sub_product(t99, t521).sub_product(t101, t520);
    let t526 = (t506 * t84).sub_product(t86, t525).sub_product(t88, t524).sub_product(t90, t521)
        .sub_product(t92, t520);
    let t527 = (-(t503 * t74)).add_product(t76, t526).add_product(t77, t525).add_product(t79, t524)
        .add_product(t81, t521).add_product(t83, t520);
    let t528 = (-(t67 * t526).add_product(t65, t527)).add_product(t70, t521).sub_product(t73, t520);
    let t529 = (-(t55 * t527).add_product(t53, t528).add_product(t56, t526).add_product(t59, t521))
        .add_product(t61, t520);
    let t530 = (t48 * t528).add_product(t46, t529);
    let t531 = (t40 * t529).sub_product(t38, t530).add_product(t38, t528);
    let bobbin_v_y_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t520;
    let bobbin_v_x_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t521;
    let rod_omega_dot_by_cylinder_v_x = (t32 * t523).sub_product(R::literal(4_166.666_666_666_667),
        t525).sub_product(t33, t522);
    let rod_v_y_dot_by_cylinder_v_x = t517.sub_product(t31, t524).sub_product(R::literal(5.0),
        t522);
    let rod_v_x_dot_by_cylinder_v_x = t515.add_product(t30, t524).sub_product(R::literal(5.0),
        t523);
    let cylinder_omega_dot_by_cylinder_v_x = t507.sub_product(t27, t527).add_product(t28, t526)
        .add_product(R::literal(2_777.777_777_777_778), t525).add_product(t29, t524);
    let cylinder_v_y_dot_by_cylinder_v_x = (-t504.add_product(R::literal(3.333_333_333_333_333_5),
        t526)).add_product(t26, t524);
    let cylinder_v_x_dot_by_cylinder_v_x = -t501.add_product(R::literal(3.333_333_333_333_333_5),
        t527).add_product(t25, t524);
    let plate_omega_dot_by_cylinder_v_x = (t22 * t528).sub_product(t21, t529).sub_product(t21, t527)
        .add_product(t22, t526).add_product(t23, t521).sub_product(t24, t520);
    let plate_v_y_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t526)
        .sub_product(R::literal(0.833_333_333_333_333_4), t528)
        .add_product(R::literal(0.833_333_333_333_333_4), t520);
    let plate_v_x_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t527)
        .sub_product(R::literal(0.833_333_333_333_333_4), t529)
        .add_product(R::literal(0.833_333_333_333_333_4), t521);
    let post_omega_dot_by_cylinder_v_x = (-(t20 * t530).add_product(t19, t531).add_product(t19,
        t529)).add_product(t20, t528);
    let post_v_y_dot_by_cylinder_v_x = (R::literal(1.25) * t528).add_product(R::literal(1.25),
        t530);
    let post_v_x_dot_by_cylinder_v_x = (R::literal(1.25) * t529).sub_product(R::literal(1.25),
        t531);
    let t532 = p.spring_damping * (sin_cylinder_phi * sin_cylinder_phi);
    let t533 = t497 * sin_cylinder_phi;
    let t534 = t499 * sin_cylinder_phi;
    let t535 = t27 * t533;
    let t536 = t504 - t535;
    let t537 = R::literal(3.333_333_333_333_333_5) * t532;
    let t538 = t537.add_product(t28, t533);
    let t539 = t538.add_product(t76, t536);
    let t540 = R::literal(2_777.777_777_777_778) * t533;
    let t541 = t540.add_product(t77, t536).sub_product(t86, t539);
    let t542 = t25 * t496;
    let t543 = t26 * t532;
    let t544 = t29 * t533;
    let t545 = t30 * t496;
    let t546 = t31 * t532;
    let t547 = (t542 - t534 - t543 + t544 + t545 - t546).add_product(t79, t536).sub_product(t88,
        t539).sub_product(t95, t541);
    let t548 = t517.add_product(t96, t541).add_product(t104, t547);
    let t549 = R::literal(5.0) * t532;
    let t550 = (-t549).add_product(t97, t541).sub_product(t106, t547).sub_product(t113, t548);
    let t551 = (t81 * t536).sub_product(t90, t539).sub_product(t99, t541).sub_product(t108, t547)
        .add_product(t115, t548).sub_product(t120, t550);
    let t552 = (t83 * t536).sub_product(t92, t539).sub_product(t101, t541).sub_product(t110, t547)
        .add_product(t117, t548).sub_product(t122, t550).sub_product(t125, t551) * t126;
    let t553 = (t551 * t123).sub_product(t125, t552);
    let t554 = (t550 * t118).sub_product(t120, t553).sub_product(t122, t552);
    let t555 = (t548 * t111).add_product(t113, t554).sub_product(t115, t553).sub_product(t117,
        t552);
    let t556 = (t547 * t102).sub_product(t104, t555).sub_product(t106, t554).sub_product(t108, t553)
        .sub_product(t110, t552);
    let t557 = (t541 * t93).sub_product(t95, t556).sub_product(t96, t555).add_product(t97, t554)
        .sub_product(t99, t553).sub_product(t101, t552);
    let t558 = (t539 * t84).sub_product(t86, t557).sub_product(t88, t556).sub_product(t90, t553)
        .sub_product(t92, t552);
    let t559 = (-(t536 * t74)).add_product(t76, t558).add_product(t77, t557).add_product(t79, t556)
        .add_product(t81, t553).add_product(t83, t552);
    let t560 = (-(t67 * t558).add_product(t65, t559)).add_product(t70, t553).sub_product(t73, t552);
    let t561 = (-(t55 * t559).add_product(t53, t560).add_product(t56, t558).add_product(t59, t553))
        .add_product(t61, t552);
    let t562 = (t48 * t560).add_product(t46, t561);
    let t563 = (t40 * t561).sub_product(t38, t562).add_product(t38, t560);
    let bobbin_v_y_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t552;
    let bobbin_v_x_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t553;
    let rod_omega_dot_by_cylinder_v_y = (t32 * t555).sub_product(R::literal(4_166.666_666_666_667),
        t557).sub_product(t33, t554);
    let rod_v_y_dot_by_cylinder_v_y = t549.sub_product(t31, t556).sub_product(R::literal(5.0),
        t554);
    let rod_v_x_dot_by_cylinder_v_y = t517.add_product(t30, t556).sub_product(R::literal(5.0),
        t555);
    let cylinder_omega_dot_by_cylinder_v_y = t540.sub_product(t27, t559).add_product(t28, t558)
        .add_product(R::literal(2_777.777_777_777_778), t557).add_product(t29, t556);
    let cylinder_v_y_dot_by_cylinder_v_y = (-t537.add_product(R::literal(3.333_333_333_333_333_5),
        t558)).add_product(t26, t556);
    let cylinder_v_x_dot_by_cylinder_v_y = -t504.add_product(R::literal(3.333_333_333_333_333_5),
        t559).add_product(t25, t556);
    let plate_omega_dot_by_cylinder_v_y = (t22 * t560).sub_product(t21, t561).sub_product(t21, t559)
        .add_product(t22, t558).add_product(t23, t553).sub_product(t24, t552);
    let plate_v_y_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t558)
        .sub_product(R::literal(0.833_333_333_333_333_4), t560)
        .add_product(R::literal(0.833_333_333_333_333_4), t552);
    let plate_v_x_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t559)
        .sub_product(R::literal(0.833_333_333_333_333_4), t561)
        .add_product(R::literal(0.833_333_333_333_333_4), t553);
    let post_omega_dot_by_cylinder_v_y = (-(t20 * t562).add_product(t19, t563).add_product(t19,
        t561)).add_product(t20, t560);
    let post_v_y_dot_by_cylinder_v_y = (R::literal(1.25) * t560).add_product(R::literal(1.25),
        t562);
    let post_v_x_dot_by_cylinder_v_y = (R::literal(1.25) * t561).sub_product(R::literal(1.25),
        t563);
    let t564 = p.spring_damping * t317;
    let t565 = R::literal(0.12) * cylinder_omega;
    let t566 = R::literal(3.333_333_333_333_333_5) * t498;
    let t567 = (-t566.add_product(t565, cos_cylinder_phi)).add_product(t27, t564);
    let t568 = R::literal(3.333_333_333_333_333_5) * t533;
    let t569 = (-t568.add_product(t565, sin_cylinder_phi).add_product(t28, t564)).add_product(t76,
        t567);
    let t570 = R::literal(2_777.777_777_777_778) * t564;
    let t571 = (-t570).add_product(t77, t567).sub_product(t86, t569);
    let t572 = (-(t25 * t498)).add_product(R::literal(2.0), ((t153 + t154).add_product(rod_v_x,
        cos_cylinder_phi).add_product(rod_v_y, sin_cylinder_phi) - t149 - t150)
        .sub_product(cylinder_v_x, cos_cylinder_phi).sub_product(cylinder_v_y, sin_cylinder_phi))
        .add_product(t26, t533).sub_product(t29, t564).sub_product(t30, t498).add_product(t31, t533)
        .add_product(t79, t567).sub_product(t88, t569).sub_product(t95, t571);
    let t573 = R::literal(5.0) * t498;
    let t574 = t573.sub_product(t96, t571).sub_product(t104, t572);
    let t575 = R::literal(5.0) * t533;
    let t576 = t575.add_product(t97, t571).sub_product(t106, t572).add_product(t113, t574);
    let t577 = (t81 * t567).sub_product(t90, t569).sub_product(t99, t571).sub_product(t108, t572)
        .sub_product(t115, t574).sub_product(t120, t576);
    let t578 = (t83 * t567).sub_product(t92, t569).sub_product(t101, t571).sub_product(t110, t572)
        .sub_product(t117, t574).sub_product(t122, t576).sub_product(t125, t577) * t126;
    let t579 = (t577 * t123).sub_product(t125, t578);
    let t580 = (t576 * t118).sub_product(t120, t579).sub_product(t122, t578);
    let t581 = (-(t574 * t111)).add_product(t113, t580).sub_product(t115, t579).sub_product(t117,
        t578);
    let t582 = (t572 * t102).sub_product(t104, t581).sub_product(t106, t580).sub_product(t108, t579)
        .sub_product(t110, t578);
    let t583 = (t571 * t93).sub_product(t95, t582).sub_product(t96, t581).add_product(t97, t580)
        .sub_product(t99, t579).sub_product(t101, t578);
    let t584 = (t569 * t84).sub_product(t86, t583).sub_product(t88, t582).sub_product(t90, t579)
        .sub_product(t92, t578);
    let t585 = (-(t567 * t74)).add_product(t76, t584).add_product(t77, t583).add_product(t79, t582)
        .add_product(t81, t579).add_product(t83, t578);
    let t586 = (-(t67 * t584).add_product(t65, t585)).add_product(t70, t579).sub_product(t73, t578);
    let t587 = (-(t55 * t585).add_product(t53, t586).add_product(t56, t584).add_product(t59, t579))
        .add_product(t61, t578);
    let t588 = (t48 * t586).add_product(t46, t587);
    let t589 = (t40 * t587).sub_product(t38, t588).add_product(t38, t586);
    let bobbin_v_y_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t578;
    let bobbin_v_x_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t579;
    let rod_omega_dot_by_cylinder_omega = (t32 * t581)
        .sub_product(R::literal(4_166.666_666_666_667), t583).sub_product(t33, t580);
    let rod_v_y_dot_by_cylinder_omega = -t575.add_product(t31, t582).add_product(R::literal(5.0),
        t580);
    let rod_v_x_dot_by_cylinder_omega = (-t573).add_product(t30, t582).sub_product(R::literal(5.0),
        t581);
    let cylinder_omega_dot_by_cylinder_omega = (-t570.add_product(t27, t585)).add_product(t28, t584)
        .add_product(R::literal(2_777.777_777_777_778), t583).add_product(t29, t582);
    let cylinder_v_y_dot_by_cylinder_omega = t568.sub_product(R::literal(3.333_333_333_333_333_5),
        t584).add_product(t26, t582);
    let cylinder_v_x_dot_by_cylinder_omega = t566.sub_product(R::literal(3.333_333_333_333_333_5),
        t585).sub_product(t25, t582);
    let plate_omega_dot_by_cylinder_omega = (t22 * t586).sub_product(t21, t587).sub_product(t21,
        t585).add_product(t22, t584).add_product(t23, t579).sub_product(t24, t578);
    let plate_v_y_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t584)
        .sub_product(R::literal(0.833_333_333_333_333_4), t586)
        .add_product(R::literal(0.833_333_333_333_333_4), t578);
    let plate_v_x_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t585)
        .sub_product(R::literal(0.833_333_333_333_333_4), t587)
        .add_product(R::literal(0.833_333_333_333_333_4), t579);
    let post_omega_dot_by_cylinder_omega = (-(t20 * t588).add_product(t19, t589).add_product(t19,
        t587)).add_product(t20, t586);
    let post_v_y_dot_by_cylinder_omega = (R::literal(1.25) * t586).add_product(R::literal(1.25),
        t588);
    let post_v_x_dot_by_cylinder_omega = (R::literal(1.25) * t587).sub_product(R::literal(1.25),
        t589);
    let t590 = t502 - t501;
    let t591 = (-t505).add_product(t76, t590);
    let t592 = (-t507).add_product(t77, t590).sub_product(t86, t591);
    let t593 = (t500 - t509 + t510 - t511 - t512 + t513).add_product(t79, t590).sub_product(t88,
        t591).sub_product(t95, t592);
    let t594 = t515.sub_product(t96, t592).sub_product(t104, t593);
    let t595 = t517.add_product(t97, t592).sub_product(t106, t593).add_product(t113, t594);
    let t596 = (t81 * t590).sub_product(t90, t591).sub_product(t99, t592).sub_product(t108, t593)
        .sub_product(t115, t594).sub_product(t120, t595);
    let t597 = (t83 * t590).sub_product(t92, t591).sub_product(t101, t592).sub_product(t110, t593)
        .sub_product(t117, t594).sub_product(t122, t595).sub_product(t125, t596) * t126;
    let t598 = (t596 * t123).sub_product(t125, t597);
    let t599 = (t595 * t118).sub_product(t120, t598).sub_product(t122, t597);
    let t600 = (-(t594 * t111)).add_product(t113, t599).sub_product(t115, t598).sub_product(t117,
        t597);
    let t601 = (t593 * t102).sub_product(t104, t600).sub_product(t106, t599).sub_product(t108, t598)
        .sub_product(t110, t597);
    let t602 = (t592 * t93).sub_product(t95, t601).sub_product(t96, t600).add_product(t97, t599)
        .sub_product(t99, t598).sub_product(t101, t597);
    let t603 = (t591 * t84).sub_product(t86, t602).sub_product(t88, t601).sub_product(t90, t598)
        .sub_product(t92, t597);
    let t604 = (-(t590 * t74)).add_product(t76, t603).add_product(t77, t602).add_product(t79, t601)
        .add_product(t81, t598).add_product(t83, t597);
    let t605 = (-(t67 * t603).add_product(t65, t604)).add_product(t70, t598).sub_product(t73, t597);
    let t606 = (-(t55 * t604).add_product(t53, t605).add_product(t56, t603).add_product(t59, t598))
        .add_product(t61, t597);
    let t607 = (t48 * t605).add_product(t46, t606);
    let t608 = (t40 * t606).sub_product(t38, t607).add_product(t38, t605);
    let bobbin_v_y_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t597;
    let bobbin_v_x_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t598;
    let rod_omega_dot_by_rod_v_x = (t32 * t600).sub_product(R::literal(4_166.666_666_666_667), t602)
        .sub_product(t33, t599);
    let rod_v_y_dot_by_rod_v_x = -t517.add_product(t31, t601).add_product(R::literal(5.0), t599);
    let rod_v_x_dot_by_rod_v_x = (-t515).add_product(t30, t601).sub_product(R::literal(5.0), t600);
    let cylinder_omega_dot_by_rod_v_x = (-t507.add_product(t27, t604)).add_product(t28, t603)
        .add_product(R::literal(2_777.777_777_777_778), t602).add_product(t29, t601);
    let cylinder_v_y_dot_by_rod_v_x = t504.sub_product(R::literal(3.333_333_333_333_333_5), t603)
        .add_product(t26, t601);
    let cylinder_v_x_dot_by_rod_v_x = t501.sub_product(R::literal(3.333_333_333_333_333_5), t604)
        .sub_product(t25, t601);
    let plate_omega_dot_by_rod_v_x = (t22 * t605).sub_product(t21, t606).sub_product(t21, t604)
        .add_product(t22, t603).add_product(t23, t598).sub_product(t24, t597);
    let plate_v_y_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t603)
        .sub_product(R::literal(0.833_333_333_333_333_4), t605)
        .add_product(R::literal(0.833_333_333_333_333_4), t597);
    let plate_v_x_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t604)
        .sub_product(R::literal(0.833_333_333_333_333_4), t606)
        .add_product(R::literal(0.833_333_333_333_333_4), t598);
    let post_omega_dot_by_rod_v_x = (-(t20 * t607).add_product(t19, t608).add_product(t19, t606))
        .add_product(t20, t605);
    let post_v_y_dot_by_rod_v_x = (R::literal(1.25) * t605).add_product(R::literal(1.25), t607);
    let post_v_x_dot_by_rod_v_x = (R::literal(1.25) * t606).sub_product(R::literal(1.25), t608);
    let t609 = t535 - t504;
    let t610 = (-t538).add_product(t76, t609);
    let t611 = (-t540).add_product(t77, t609).sub_product(t86, t610);
    let t612 = (t534 - t542 + t543 - t544 - t545 + t546).add_product(t79, t609).sub_product(t88,
        t610).sub_product(t95, t611);
    let t613 = t517.sub_product(t96, t611).sub_product(t104, t612);
    let t614 = t549.add_product(t97, t611).sub_product(t106, t612).add_product(t113, t613);
    let t615 = (t81 * t609).sub_product(t90, t610).sub_product(t99, t611).sub_product(t108, t612)
        .sub_product(t115, t613).sub_product(t120, t614);
    let t616 = (t83 * t609).sub_product(t92, t610).sub_product(t101, t611).sub_product(t110, t612)
        .sub_product(t117, t613).sub_product(t122, t614).sub_product(t125, t615) * t126;
    let t617 = (t615 * t123).sub_product(t125, t616);
    let t618 = (t614 * t118).sub_product(t120, t617).sub_product(t122, t616);
    let t619 = (-(t613 * t111)).add_product(t113, t618).sub_product(t115, t617).sub_product(t117,
        t616);
    let t620 = (t612 * t102).sub_product(t104, t619).sub_product(t106, t618).sub_product(t108, t617)
        .sub_product(t110, t616);
    let t621 = (t611 * t93).sub_product(t95, t620).sub_product(t96, t619).add_product(t97, t618)
        .sub_product(t99, t617).sub_product(t101, t616);
    let t622 = (t610 * t84).sub_product(t86, t621).sub_product(t88, t620).sub_product(t90, t617)
        .sub_product(t92, t616);
    let t623 = (-(t609 * t74)).add_product(t76, t622).add_product(t77, t621).add_product(t79, t620)
        .add_product(t81, t617).add_product(t83, t616);
    let t624 = (-(t67 * t622).add_product(t65, t623)).add_product(t70, t617).sub_product(t73, t616);
    let t625 = (-(t55 * t623).add_product(t53, t624).add_product(t56, t622).add_product(t59, t617))
        .add_product(t61, t616);
    let t626 = (t48 * t624).add_product(t46, t625);
    let t627 = (t40 * t625).sub_product(t38, t626).add_product(t38, t624);
    let bobbin_v_y_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t616;
    let bobbin_v_x_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t617;
    let rod_omega_dot_by_rod_v_y = (t32 * t619).sub_product(R::literal(4_166.666_666_666_667), t621)
        .sub_product(t33, t618);
    let rod_v_y_dot_by_rod_v_y = -t549.add_product(t31, t620).add_product(R::literal(5.0), t618);
    let rod_v_x_dot_by_rod_v_y = (-t517).add_product(t30, t620).sub_product(R::literal(5.0), t619);
    let cylinder_omega_dot_by_rod_v_y = (-t540.add_product(t27, t623)).add_product(t28, t622)
        .add_product(R::literal(2_777.777_777_777_778), t621).add_product(t29, t620);
    let cylinder_v_y_dot_by_rod_v_y = t537.sub_product(R::literal(3.333_333_333_333_333_5), t622)
        .add_product(t26, t620);
    let cylinder_v_x_dot_by_rod_v_y = t504.sub_product(R::literal(3.333_333_333_333_333_5), t623)
        .sub_product(t25, t620);
    let plate_omega_dot_by_rod_v_y = (t22 * t624).sub_product(t21, t625).sub_product(t21, t623)
        .add_product(t22, t622).add_product(t23, t617).sub_product(t24, t616);
    let plate_v_y_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t622)
        .sub_product(R::literal(0.833_333_333_333_333_4), t624)
        .add_product(R::literal(0.833_333_333_333_333_4), t616);
    let plate_v_x_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t623)
        .sub_product(R::literal(0.833_333_333_333_333_4), t625)
        .add_product(R::literal(0.833_333_333_333_333_4), t617);
    let post_omega_dot_by_rod_v_y = (-(t20 * t626).add_product(t19, t627).add_product(t19, t625))
        .add_product(t20, t624);
    let post_v_y_dot_by_rod_v_y = (R::literal(1.25) * t624).add_product(R::literal(1.25), t626);
    let post_v_x_dot_by_rod_v_y = (R::literal(1.25) * t625).sub_product(R::literal(1.25), t627);
    let t628 = R::literal(0.12) * rod_omega;
    let t629 = t628 * cos_rod_phi;
    let t630 = (t628 * sin_rod_phi).add_product(t113, t629);
    let t631 = (t115 * t629).add_product(t120, t630);
    let t632 = (-(t117 * t629).add_product(t122, t630)).add_product(t125, t631) * t126;
    let t633 = (t631 * t123).add_product(t125, t632);
    let t634 = (t630 * t118).add_product(t120, t633).sub_product(t122, t632);
    let t635 = (-(t629 * t111)).add_product(t113, t634).add_product(t115, t633).sub_product(t117,
        t632);
    let t636 = (-(t106 * t634).add_product(t104, t635)).add_product(t108, t633).sub_product(t110,
        t632);
    let t637 = (-(t96 * t635).add_product(t95, t636)).add_product(t97, t634).add_product(t99, t633)
        .sub_product(t101, t632);
    let t638 = (-(t88 * t636).add_product(t86, t637)).add_product(t90, t633).sub_product(t92, t632);
    let t639 = (t77 * t637).add_product(t76, t638).add_product(t79, t636).sub_product(t81, t633)
        .add_product(t83, t632);
    let t640 = (t67 * t638).add_product(t65, t639).add_product(t70, t633).add_product(t73, t632);
    let t641 = (-(t55 * t639)).add_product(t53, t640).sub_product(t56, t638).add_product(t59, t633)
        .add_product(t61, t632);
    let t642 = (t48 * t640).sub_product(t46, t641);
    let t643 = (t40 * t641).add_product(t38, t642).sub_product(t38, t640);
    let bobbin_v_y_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t632;
    let bobbin_v_x_dot_by_rod_omega = R::literal(1.428_571_428_571_428_6) * t633;
    let rod_omega_dot_by_rod_omega = (t32 * t635).sub_product(R::literal(4_166.666_666_666_667),
        t637).sub_product(t33, t634);
    let rod_v_y_dot_by_rod_omega = -(R::literal(5.0) * t634).add_product(t31, t636);
    let rod_v_x_dot_by_rod_omega = (R::literal(-5.0) * t635).add_product(t30, t636);
    let cylinder_omega_dot_by_rod_omega = (t28 * t638).sub_product(t27, t639)
        .add_product(R::literal(2_777.777_777_777_778), t637).add_product(t29, t636);
    let cylinder_v_y_dot_by_rod_omega = (t26 * t636)
        .sub_product(R::literal(3.333_333_333_333_333_5), t638);
    let cylinder_v_x_dot_by_rod_omega = -(t25 * t636)
        .add_product(R::literal(3.333_333_333_333_333_5), t639);
    let plate_omega_dot_by_rod_omega = (-(t22 * t640).add_product(t21, t641).add_product(t21, t639))
        .add_product(t22, t638).sub_product(t23, t633).sub_product(t24, t632);
    let plate_v_y_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t638)
        .add_product(R::literal(0.833_333_333_333_333_4), t640)
        .add_product(R::literal(0.833_333_333_333_333_4), t632);
    let plate_v_x_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t639)
        .sub_product(R::literal(0.833_333_333_333_333_4), t641)
        .sub_product(R::literal(0.833_333_333_333_333_4), t633);
    let post_omega_dot_by_rod_omega = (t20 * t642).sub_product(t19, t643).sub_product(t19, t641)
        .sub_product(t20, t640);
    let post_v_y_dot_by_rod_omega = -(R::literal(1.25) * t640).add_product(R::literal(1.25), t642);
    let post_v_x_dot_by_rod_omega = (R::literal(1.25) * t641).sub_product(R::literal(1.25), t643);
    let t644 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t10 / between_squared));
    let t645 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t9 * t11 / between_squared));
    let t646 = (-t645).add_product(t125, t644) * t126;
    let t647 = (t644 * t123).add_product(t125, t646);
    let t648 = (-(t122 * t646)).add_product(t120, t647);
    let t649 = (t115 * t647).add_product(t113, t648).sub_product(t117, t646);
    let t650 = (-(t106 * t648).add_product(t104, t649)).add_product(t108, t647).sub_product(t110,
        t646);
    let t651 = (-(t96 * t649).add_product(t95, t650)).add_product(t97, t648).add_product(t99, t647)
        .sub_product(t101, t646);
    let t652 = (-(t88 * t650).add_product(t86, t651)).add_product(t90, t647).sub_product(t92, t646);
    let t653 = (t77 * t651).add_product(t76, t652).add_product(t79, t650).sub_product(t81, t647)
        .add_product(t83, t646);
    let t654 = (t67 * t652).add_product(t65, t653).add_product(t70, t647).add_product(t73, t646);
    let t655 = (-(t55 * t653)).add_product(t53, t654).sub_product(t56, t652).add_product(t59, t647)
        .add_product(t61, t646);
    let t656 = (t48 * t654).sub_product(t46, t655);
    let t657 = (t40 * t655).add_product(t38, t656).sub_product(t38, t654);
    let bobbin_v_y_dot_by_bobbin_v_x = t645.sub_product(R::literal(1.428_571_428_571_428_6), t646);
    let bobbin_v_x_dot_by_bobbin_v_x = t644.add_product(R::literal(1.428_571_428_571_428_6), t647);
    let rod_omega_dot_by_bobbin_v_x = (t32 * t649).sub_product(R::literal(4_166.666_666_666_667),
        t651).sub_product(t33, t648);
    let rod_v_y_dot_by_bobbin_v_x = -(R::literal(5.0) * t648).add_product(t31, t650);
    let rod_v_x_dot_by_bobbin_v_x = (R::literal(-5.0) * t649).add_product(t30, t650);
    let cylinder_omega_dot_by_bobbin_v_x = (t28 * t652).sub_product(t27, t653)
        .add_product(R::literal(2_777.777_777_777_778), t651).add_product(t29, t650);
    let cylinder_v_y_dot_by_bobbin_v_x = (t26 * t650)
        .sub_product(R::literal(3.333_333_333_333_333_5), t652);
    let cylinder_v_x_dot_by_bobbin_v_x = -(t25 * t650)
        .add_product(R::literal(3.333_333_333_333_333_5), t653);
    let plate_omega_dot_by_bobbin_v_x = (-(t22 * t654).add_product(t21, t655).add_product(t21,
        t653)).add_product(t22, t652).sub_product(t23, t647).sub_product(t24, t646);
    let plate_v_y_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t652)
        .add_product(R::literal(0.833_333_333_333_333_4), t654)
        .add_product(R::literal(0.833_333_333_333_333_4), t646);
    let plate_v_x_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t653)
        .sub_product(R::literal(0.833_333_333_333_333_4), t655)
        .sub_product(R::literal(0.833_333_333_333_333_4), t647);
    let post_omega_dot_by_bobbin_v_x = (t20 * t656).sub_product(t19, t657).sub_product(t19, t655)
        .sub_product(t20, t654);
    let post_v_y_dot_by_bobbin_v_x = -(R::literal(1.25) * t654).add_product(R::literal(1.25), t656);
    let post_v_x_dot_by_bobbin_v_x = (R::literal(1.25) * t655).sub_product(R::literal(1.25), t657);
    let t658 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t12 / between_squared));
    let t659 = (-t658).add_product(t125, t645) * t126;
    let t660 = (t645 * t123).add_product(t125, t659);
    let t661 = (-(t122 * t659)).add_product(t120, t660);
    let t662 = (t115 * t660).add_product(t113, t661).sub_product(t117, t659);
    let t663 = (-(t106 * t661).add_product(t104, t662)).add_product(t108, t660).sub_product(t110,
        t659);
    let t664 = (-(t96 * t662).add_product(t95, t663)).add_product(t97, t661).add_product(t99, t660)
        .sub_product(t101, t659);
    let t665 = (-(t88 * t663).add_product(t86, t664)).add_product(t90, t660).sub_product(t92, t659);
    let t666 = (t77 * t664).add_product(t76, t665).add_product(t79, t663).sub_product(t81, t660)
        .add_product(t83, t659);
    let t667 = (t67 * t665).add_product(t65, t666).add_product(t70, t660).add_product(t73, t659);
    let t668 = (-(t55 * t666)).add_product(t53, t667).sub_product(t56, t665).add_product(t59, t660)
        .add_product(t61, t659);
    let t669 = (t48 * t667).sub_product(t46, t668);
    let t670 = (t40 * t668).add_product(t38, t669).sub_product(t38, t667);
    let bobbin_v_y_dot_by_bobbin_v_y = t658.sub_product(R::literal(1.428_571_428_571_428_6), t659);
    let bobbin_v_x_dot_by_bobbin_v_y = t645.add_product(R::literal(1.428_571_428_571_428_6), t660);
    let rod_omega_dot_by_bobbin_v_y = (t32 * t662).sub_product(R::literal(4_166.666_666_666_667),
        t664).sub_product(t33, t661);
    let rod_v_y_dot_by_bobbin_v_y = -(R::literal(5.0) * t661).add_product(t31, t663);
    let rod_v_x_dot_by_bobbin_v_y = (R::literal(-5.0) * t662).add_product(t30, t663);
    let cylinder_omega_dot_by_bobbin_v_y = (t28 * t665).sub_product(t27, t666)
        .add_product(R::literal(2_777.777_777_777_778), t664).add_product(t29, t663);
    let cylinder_v_y_dot_by_bobbin_v_y = (t26 * t663)
        .sub_product(R::literal(3.333_333_333_333_333_5), t665);
    let cylinder_v_x_dot_by_bobbin_v_y = -(t25 * t663)
        .add_product(R::literal(3.333_333_333_333_333_5), t666);
    let plate_omega_dot_by_bobbin_v_y = (-(t22 * t667).add_product(t21, t668).add_product(t21,
        t666)).add_product(t22, t665).sub_product(t23, t660).sub_product(t24, t659);
    let plate_v_y_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t665)
        .add_product(R::literal(0.833_333_333_333_333_4), t667)
        .add_product(R::literal(0.833_333_333_333_333_4), t659);
    let plate_v_x_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t666)
        .sub_product(R::literal(0.833_333_333_333_333_4), t668)
        .sub_product(R::literal(0.833_333_333_333_333_4), t660);
    let post_omega_dot_by_bobbin_v_y = (t20 * t669).sub_product(t19, t670).sub_product(t19, t668)
        .sub_product(t20, t667);
    let post_v_y_dot_by_bobbin_v_y = -(R::literal(1.25) * t667).add_product(R::literal(1.25), t669);
    let post_v_x_dot_by_bobbin_v_y = (R::literal(1.25) * t668).sub_product(R::literal(1.25), t670);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        post_v_x_dot_by_post_phi, post_v_x_dot_by_plate_phi, post_v_x_dot_by_cylinder_x,
        post_v_x_dot_by_cylinder_y, post_v_x_dot_by_cylinder_phi, post_v_x_dot_by_rod_x,
        post_v_x_dot_by_rod_y, post_v_x_dot_by_rod_phi, post_v_x_dot_by_bobbin_x,
        post_v_x_dot_by_bobbin_y, post_v_x_dot_by_post_omega, post_v_x_dot_by_plate_omega,
        post_v_x_dot_by_cylinder_v_x, post_v_x_dot_by_cylinder_v_y, post_v_x_dot_by_cylinder_omega,
        post_v_x_dot_by_rod_v_x, post_v_x_dot_by_rod_v_y, post_v_x_dot_by_rod_omega,
        post_v_x_dot_by_bobbin_v_x, post_v_x_dot_by_bobbin_v_y, post_v_y_dot_by_post_phi,
        post_v_y_dot_by_plate_phi, post_v_y_dot_by_cylinder_x, post_v_y_dot_by_cylinder_y,
        post_v_y_dot_by_cylinder_phi, post_v_y_dot_by_rod_x, post_v_y_dot_by_rod_y,
        post_v_y_dot_by_rod_phi, post_v_y_dot_by_bobbin_x, post_v_y_dot_by_bobbin_y,
        post_v_y_dot_by_post_omega, post_v_y_dot_by_plate_omega, post_v_y_dot_by_cylinder_v_x,
        post_v_y_dot_by_cylinder_v_y, post_v_y_dot_by_cylinder_omega, post_v_y_dot_by_rod_v_x,
        post_v_y_dot_by_rod_v_y, post_v_y_dot_by_rod_omega, post_v_y_dot_by_bobbin_v_x,
        post_v_y_dot_by_bobbin_v_y, post_omega_dot_by_post_phi, post_omega_dot_by_plate_phi,
        post_omega_dot_by_cylinder_x, post_omega_dot_by_cylinder_y, post_omega_dot_by_cylinder_phi,
        post_omega_dot_by_rod_x, post_omega_dot_by_rod_y, post_omega_dot_by_rod_phi,
        post_omega_dot_by_bobbin_x, post_omega_dot_by_bobbin_y, post_omega_dot_by_post_omega,
        post_omega_dot_by_plate_omega, post_omega_dot_by_cylinder_v_x,
        post_omega_dot_by_cylinder_v_y, post_omega_dot_by_cylinder_omega,
        post_omega_dot_by_rod_v_x, post_omega_dot_by_rod_v_y, post_omega_dot_by_rod_omega,
        post_omega_dot_by_bobbin_v_x, post_omega_dot_by_bobbin_v_y, plate_v_x_dot_by_post_phi,
        plate_v_x_dot_by_plate_phi, plate_v_x_dot_by_cylinder_x, plate_v_x_dot_by_cylinder_y,
        plate_v_x_dot_by_cylinder_phi, plate_v_x_dot_by_rod_x, plate_v_x_dot_by_rod_y,
        plate_v_x_dot_by_rod_phi, plate_v_x_dot_by_bobbin_x, plate_v_x_dot_by_bobbin_y,
        plate_v_x_dot_by_post_omega, plate_v_x_dot_by_plate_omega, plate_v_x_dot_by_cylinder_v_x,
        plate_v_x_dot_by_cylinder_v_y, plate_v_x_dot_by_cylinder_omega, plate_v_x_dot_by_rod_v_x,
        plate_v_x_dot_by_rod_v_y, plate_v_x_dot_by_rod_omega, plate_v_x_dot_by_bobbin_v_x,
        plate_v_x_dot_by_bobbin_v_y, plate_v_y_dot_by_post_phi, plate_v_y_dot_by_plate_phi,
        plate_v_y_dot_by_cylinder_x, plate_v_y_dot_by_cylinder_y, plate_v_y_dot_by_cylinder_phi,
        plate_v_y_dot_by_rod_x, plate_v_y_dot_by_rod_y, plate_v_y_dot_by_rod_phi,
        plate_v_y_dot_by_bobbin_x, plate_v_y_dot_by_bobbin_y, plate_v_y_dot_by_post_omega,
        plate_v_y_dot_by_plate_omega, plate_v_y_dot_by_cylinder_v_x, plate_v_y_dot_by_cylinder_v_y,
        plate_v_y_dot_by_cylinder_omega, plate_v_y_dot_by_rod_v_x, plate_v_y_dot_by_rod_v_y,
        plate_v_y_dot_by_rod_omega, plate_v_y_dot_by_bobbin_v_x, plate_v_y_dot_by_bobbin_v_y,
        plate_omega_dot_by_post_phi, plate_omega_dot_by_plate_phi, plate_omega_dot_by_cylinder_x,
        plate_omega_dot_by_cylinder_y, plate_omega_dot_by_cylinder_phi, plate_omega_dot_by_rod_x,
        plate_omega_dot_by_rod_y, plate_omega_dot_by_rod_phi, plate_omega_dot_by_bobbin_x,
        plate_omega_dot_by_bobbin_y, plate_omega_dot_by_post_omega, plate_omega_dot_by_plate_omega,
        plate_omega_dot_by_cylinder_v_x, plate_omega_dot_by_cylinder_v_y,
        plate_omega_dot_by_cylinder_omega, plate_omega_dot_by_rod_v_x, plate_omega_dot_by_rod_v_y,
        plate_omega_dot_by_rod_omega, plate_omega_dot_by_bobbin_v_x, plate_omega_dot_by_bobbin_v_y,
        cylinder_v_x_dot_by_post_phi, cylinder_v_x_dot_by_plate_phi,
        cylinder_v_x_dot_by_cylinder_x, cylinder_v_x_dot_by_cylinder_y,
        cylinder_v_x_dot_by_cylinder_phi, cylinder_v_x_dot_by_rod_x, cylinder_v_x_dot_by_rod_y,
        cylinder_v_x_dot_by_rod_phi, cylinder_v_x_dot_by_bobbin_x, cylinder_v_x_dot_by_bobbin_y,
        cylinder_v_x_dot_by_post_omega, cylinder_v_x_dot_by_plate_omega,
        cylinder_v_x_dot_by_cylinder_v_x, cylinder_v_x_dot_by_cylinder_v_y,
        cylinder_v_x_dot_by_cylinder_omega, cylinder_v_x_dot_by_rod_v_x,
        cylinder_v_x_dot_by_rod_v_y, cylinder_v_x_dot_by_rod_omega, cylinder_v_x_dot_by_bobbin_v_x,
        cylinder_v_x_dot_by_bobbin_v_y, cylinder_v_y_dot_by_post_phi,
        cylinder_v_y_dot_by_plate_phi, cylinder_v_y_dot_by_cylinder_x,
        cylinder_v_y_dot_by_cylinder_y, cylinder_v_y_dot_by_cylinder_phi,
        cylinder_v_y_dot_by_rod_x, cylinder_v_y_dot_by_rod_y, cylinder_v_y_dot_by_rod_phi,
        cylinder_v_y_dot_by_bobbin_x, cylinder_v_y_dot_by_bobbin_y, cylinder_v_y_dot_by_post_omega,
        cylinder_v_y_dot_by_plate_omega, cylinder_v_y_dot_by_cylinder_v_x,
        cylinder_v_y_dot_by_cylinder_v_y, cylinder_v_y_dot_by_cylinder_omega,
        cylinder_v_y_dot_by_rod_v_x, cylinder_v_y_dot_by_rod_v_y, cylinder_v_y_dot_by_rod_omega,
        cylinder_v_y_dot_by_bobbin_v_x, cylinder_v_y_dot_by_bobbin_v_y,
        cylinder_omega_dot_by_post_phi, cylinder_omega_dot_by_plate_phi,
        cylinder_omega_dot_by_cylinder_x, cylinder_omega_dot_by_cylinder_y,
        cylinder_omega_dot_by_cylinder_phi, cylinder_omega_dot_by_rod_x,
        cylinder_omega_dot_by_rod_y, cylinder_omega_dot_by_rod_phi, cylinder_omega_dot_by_bobbin_x,
        cylinder_omega_dot_by_bobbin_y, cylinder_omega_dot_by_post_omega,
        cylinder_omega_dot_by_plate_omega, cylinder_omega_dot_by_cylinder_v_x,
        cylinder_omega_dot_by_cylinder_v_y, cylinder_omega_dot_by_cylinder_omega,
        cylinder_omega_dot_by_rod_v_x, cylinder_omega_dot_by_rod_v_y,
        cylinder_omega_dot_by_rod_omega, cylinder_omega_dot_by_bobbin_v_x,
        cylinder_omega_dot_by_bobbin_v_y, rod_v_x_dot_by_post_phi, rod_v_x_dot_by_plate_phi,
        rod_v_x_dot_by_cylinder_x, rod_v_x_dot_by_cylinder_y, rod_v_x_dot_by_cylinder_phi,
        rod_v_x_dot_by_rod_x, rod_v_x_dot_by_rod_y, rod_v_x_dot_by_rod_phi,
        rod_v_x_dot_by_bobbin_x, rod_v_x_dot_by_bobbin_y, rod_v_x_dot_by_post_omega,
        rod_v_x_dot_by_plate_omega, rod_v_x_dot_by_cylinder_v_x, rod_v_x_dot_by_cylinder_v_y,
        rod_v_x_dot_by_cylinder_omega, rod_v_x_dot_by_rod_v_x, rod_v_x_dot_by_rod_v_y,
        rod_v_x_dot_by_rod_omega, rod_v_x_dot_by_bobbin_v_x, rod_v_x_dot_by_bobbin_v_y,
        rod_v_y_dot_by_post_phi, rod_v_y_dot_by_plate_phi, rod_v_y_dot_by_cylinder_x,
        rod_v_y_dot_by_cylinder_y, rod_v_y_dot_by_cylinder_phi, rod_v_y_dot_by_rod_x,
        rod_v_y_dot_by_rod_y, rod_v_y_dot_by_rod_phi, rod_v_y_dot_by_bobbin_x,
        rod_v_y_dot_by_bobbin_y, rod_v_y_dot_by_post_omega, rod_v_y_dot_by_plate_omega,
        rod_v_y_dot_by_cylinder_v_x, rod_v_y_dot_by_cylinder_v_y, rod_v_y_dot_by_cylinder_omega,
        rod_v_y_dot_by_rod_v_x, rod_v_y_dot_by_rod_v_y, rod_v_y_dot_by_rod_omega,
        rod_v_y_dot_by_bobbin_v_x, rod_v_y_dot_by_bobbin_v_y, rod_omega_dot_by_post_phi,
        rod_omega_dot_by_plate_phi, rod_omega_dot_by_cylinder_x, rod_omega_dot_by_cylinder_y,
        rod_omega_dot_by_cylinder_phi, rod_omega_dot_by_rod_x, rod_omega_dot_by_rod_y,
        rod_omega_dot_by_rod_phi, rod_omega_dot_by_bobbin_x, rod_omega_dot_by_bobbin_y,
        rod_omega_dot_by_post_omega, rod_omega_dot_by_plate_omega, rod_omega_dot_by_cylinder_v_x,
        rod_omega_dot_by_cylinder_v_y, rod_omega_dot_by_cylinder_omega, rod_omega_dot_by_rod_v_x,
        rod_omega_dot_by_rod_v_y, rod_omega_dot_by_rod_omega, rod_omega_dot_by_bobbin_v_x,
        rod_omega_dot_by_bobbin_v_y, bobbin_v_x_dot_by_post_phi, bobbin_v_x_dot_by_plate_phi,
        bobbin_v_x_dot_by_cylinder_x, bobbin_v_x_dot_by_cylinder_y, bobbin_v_x_dot_by_cylinder_phi,
        bobbin_v_x_dot_by_rod_x, bobbin_v_x_dot_by_rod_y, bobbin_v_x_dot_by_rod_phi,
        bobbin_v_x_dot_by_bobbin_x, bobbin_v_x_dot_by_bobbin_y, bobbin_v_x_dot_by_post_omega,
        bobbin_v_x_dot_by_plate_omega, bobbin_v_x_dot_by_cylinder_v_x,
        bobbin_v_x_dot_by_cylinder_v_y, bobbin_v_x_dot_by_cylinder_omega,
        bobbin_v_x_dot_by_rod_v_x, bobbin_v_x_dot_by_rod_v_y, bobbin_v_x_dot_by_rod_omega,
        bobbin_v_x_dot_by_bobbin_v_x, bobbin_v_x_dot_by_bobbin_v_y, bobbin_v_y_dot_by_post_phi,
        bobbin_v_y_dot_by_plate_phi, bobbin_v_y_dot_by_cylinder_x, bobbin_v_y_dot_by_cylinder_y,
        bobbin_v_y_dot_by_cylinder_phi, bobbin_v_y_dot_by_rod_x, bobbin_v_y_dot_by_rod_y,
        bobbin_v_y_dot_by_rod_phi, bobbin_v_y_dot_by_bobbin_x, bobbin_v_y_dot_by_bobbin_y,
        bobbin_v_y_dot_by_post_omega, bobbin_v_y_dot_by_plate_omega,
        bobbin_v_y_dot_by_cylinder_v_x, bobbin_v_y_dot_by_cylinder_v_y,
        bobbin_v_y_dot_by_cylinder_omega, bobbin_v_y_dot_by_rod_v_x, bobbin_v_y_dot_by_rod_v_y,
        bobbin_v_y_dot_by_rod_omega, bobbin_v_y_dot_by_bobbin_v_x, bobbin_v_y_dot_by_bobbin_v_y]
}

/// `dy'/dp`, values in the order of its pattern. 1069 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 56] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, _, _, _, _, _, cylinder_v_x, cylinder_v_y, cylinder_omega,
        rod_v_x, rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let t1 = R::literal(0.1) * sin_post_phi;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * sin_rod_phi;
    let t7 = bobbin_x - R::literal(0.328);
    let t8 = bobbin_y - R::literal(0.058);
    let between = (t7 * t7).add_product(t8, t8).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t7).add_product(bobbin_v_y, t8) / between;
    let t9 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t9)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t10 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t11 = R::literal(0.01) * t10;
    let t12 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t13 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t14 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = R::literal(4.0) * t10;
    let t18 = t12 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
    let t28 = t13 * t1;
    let t29 = R::literal(1.25) + t28;
    let t30 = R::literal(1.0) / t29;
    let t31 = t14 * t1;
    let t32 = t31 * t30;
    let t33 = R::literal(1.25) - t28;
    let t34 = t33 * t30;
    let t35 = t14 * t0;
    let t36 = R::literal(1.25) + t35;
    let t37 = t32 * t31;
    let t38 = R::literal(1.0) / (t37 - t36);
    let t39 = (t13 * t0).add_product(t34, t31);
    let t40 = t39 * t38;
    let t41 = R::literal(1.25) - t35 + t37;
    let t42 = t41 * t38;
    let t43 = t15 * t3;
    let t44 = R::literal(1.0) / (-(t29 + R::literal(0.833_333_333_333_333_4) + t43))
        .add_product(t34, t33).sub_product(t40, t39);
    let t45 = t16 * t3;
    let t46 = (t31 + t45).add_product(t32, t33).sub_product(t42, t39);
    let t47 = t46 * t44;
    let t48 = R::literal(0.833_333_333_333_333_4) - t43;
    let t49 = t48 * t44;
    let t50 = t45 * t44;
    let t51 = t17 * t3;
    let t52 = R::literal(0.833_333_333_333_333_4) + t51;
    let t53 = t52 * t44;
    let t54 = t18 * t3;
    let t55 = t54 * t44;
    let t56 = t16 * t2;
    let t57 = R::literal(1.0) / (t37 - (t36 + R::literal(0.833_333_333_333_333_4) + t56))
        .sub_product(t42, t41).sub_product(t47, t46);
    let t58 = (t15 * t2).sub_product(t49, t46);
    let t59 = t58 * t57;
    let t60 = (R::literal(0.833_333_333_333_333_4) - t56).sub_product(t50, t46);
    let t61 = t60 * t57;
    let t62 = t17 * t2;
    let t63 = t62.add_product(t53, t46);
    let t64 = t63 * t57;
    let t65 = t18 * t2;
    let t66 = (R::literal(0.833_333_333_333_333_4) + t65).add_product(t55, t46);
    let t67 = t66 * t57;
    let t68 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t43
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t5).add_product(t49, t48)
        .add_product(t59, t58);
    let t69 = t45.add_product(t22, t5).sub_product(t50, t48).sub_product(t61, t58);
    let t70 = t69 * t68;
    let t71 = t21 * t68;
    let t72 = (-t19).add_product(t23, t5);
    let t73 = t72 * t68;
    let t74 = (t51 - R::literal(0.833_333_333_333_333_4)).sub_product(t53, t48).add_product(t64,
        t58);
    let t75 = t74 * t68;
    let t76 = (-t54).add_product(t55, t48).sub_product(t67, t58);
    let t77 = t76 * t68;
    let t78 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t56
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t50, t45)
        .add_product(t61, t60)).add_product(t70, t69);
    let t79 = (-t22).add_product(t71, t69);
    let t80 = t79 * t78;
    let t81 = t20.sub_product(t23, t4).add_product(t73, t69);
    let t82 = t81 * t78;
    let t83 = (-t62.add_product(t53, t45)).add_product(t64, t60).add_product(t75, t69);
    let t84 = t83 * t78;
    let t85 = (t65 - R::literal(0.833_333_333_333_333_4)).add_product(t55, t45).sub_product(t67,
        t60).add_product(t77, t69);
    let t86 = t85 * t78;
    let t87 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t71, t21)
        .sub_product(t80, t79);
    let t88 = (-t23).add_product(t73, t21).sub_product(t82, t79);
    let t89 = t88 * t87;
    let t90 = t26 * t87;
    let t91 = t27 * t87;
    let t92 = (t75 * t21).sub_product(t84, t79);
    let t93 = t92 * t87;
    let t94 = (t77 * t21).sub_product(t86, t79);
    let t95 = t94 * t87;
    let t96 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t73, t72).sub_product(t82, t81).sub_product(t89, t88);
    let t97 = t24.sub_product(t90, t88);
    let t98 = t97 * t96;
    let t99 = (-t25).add_product(t91, t88);
    let t100 = t99 * t96;
    let t101 = (t75 * t72).sub_product(t84, t81).sub_product(t93, t88);
    let t102 = t101 * t96;
    let t103 = (t77 * t72).sub_product(t86, t81).sub_product(t95, t88);
    let t104 = t103 * t96;
    let t105 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t90, t26)
        .add_product(t98, t97);
    let t106 = (t27 * t6).add_product(t91, t26).sub_product(t100, t97);
    let t107 = t106 * t105;
    let t108 = (t93 * t26).add_product(t102, t97);
    let t109 = t108 * t105;
    let t110 = (t95 * t26).add_product(t104, t97);
    let t111 = t110 * t105;
    let t112 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t91, t27).add_product(t100, t99)).add_product(t107, t106);
    let t113 = (t93 * t27).sub_product(t102, t99).sub_product(t109, t106);
    let t114 = t113 * t112;
    let t115 = (t95 * t27).sub_product(t104, t99).sub_product(t111, t106);
    let t116 = t115 * t112;
    let t117 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t11)
        + R::literal(1.428_571_428_571_428_6)).add_product(t53, t52).add_product(t64, t63))
        .add_product(t75, t74).sub_product(t84, t83).sub_product(t93, t92).sub_product(t102, t101)
        .add_product(t109, t108).sub_product(t114, t113);
    let t118 = (t18 * t11).add_product(t55, t52).add_product(t67, t63).add_product(t77, t74)
        .sub_product(t86, t83).sub_product(t95, t92).sub_product(t104, t101).add_product(t111, t108)
        .sub_product(t116, t113);
    let t119 = t118 * t117;
    let t120 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t12)
        + R::literal(1.428_571_428_571_428_6)).add_product(t55, t54).add_product(t67, t66))
        .add_product(t77, t76).sub_product(t86, t85).sub_product(t95, t94).sub_product(t104, t103)
        .add_product(t111, t110).sub_product(t116, t115).sub_product(t119, t118);
    let t121 = slide - R::literal(0.116);
    let t122 = t121 * cos_cylinder_phi;
    let t123 = t121 * sin_cylinder_phi;
    let t124 = t121 * t9;
    let t125 = R::literal(3.333_333_333_333_333_5) * t122;
    let t126 = (-t125).add_product(t21, t124);
    let t127 = R::literal(3.333_333_333_333_333_5) * t123;
    let t128 = (-t127.add_product(t22, t124)).add_product(t70, t126);
    let t129 = R::literal(2_777.777_777_777_778) * t124;
    let t130 = (-t129).add_product(t71, t126).sub_product(t80, t128);
    let t131 = (t20 * t123).sub_product(t19, t122).sub_product(t23, t124).sub_product(t24, t122)
        .add_product(t25, t123).add_product(t73, t126).sub_product(t82, t128).sub_product(t89,
        t130);
    let t132 = R::literal(5.0) * t122;
    let t133 = t132.sub_product(t90, t130).sub_product(t98, t131);
    let t134 = R::literal(5.0) * t123;
    let t135 = t134.add_product(t91, t130).sub_product(t100, t131).add_product(t107, t133);
    let t136 = (t75 * t126).sub_product(t84, t128).sub_product(t93, t130).sub_product(t102, t131)
        .sub_product(t109, t133).sub_product(t114, t135);
    let t137 = (t77 * t126).sub_product(t86, t128).sub_product(t95, t130).sub_product(t104, t131)
        .sub_product(t111, t133).sub_product(t116, t135).sub_product(t119, t136) * t120;
    let t138 = (t136 * t117).sub_product(t119, t137);
    let t139 = (t135 * t112).sub_product(t114, t138).sub_product(t116, t137);
    let t140 = (-(t133 * t105)).add_product(t107, t139).sub_product(t109, t138).sub_product(t111,
        t137);
    let t141 = (t131 * t96).sub_product(t98, t140).sub_product(t100, t139).sub_product(t102, t138)
        .sub_product(t104, t137);
    let t142 = (t130 * t87).sub_product(t89, t141).sub_product(t90, t140).add_product(t91, t139)
        .sub_product(t93, t138).sub_product(t95, t137);
    let t143 = (t128 * t78).sub_product(t80, t142).sub_product(t82, t141).sub_product(t84, t138)
        .sub_product(t86, t137);
    let t144 = (-(t126 * t68)).add_product(t70, t143).add_product(t71, t142).add_product(t73, t141)
        .add_product(t75, t138).add_product(t77, t137);
    let t145 = (-(t61 * t143).add_product(t59, t144)).add_product(t64, t138).sub_product(t67, t137);
    let t146 = (-(t49 * t144).add_product(t47, t145).add_product(t50, t143).add_product(t53, t138))
        .add_product(t55, t137);
    let t147 = (t42 * t145).add_product(t40, t146);
    let t148 = (t34 * t146).sub_product(t32, t147).add_product(t32, t145);
    let bobbin_v_y_dot_by_spring_stiffness = R::literal(-1.428_571_428_571_428_6) * t137;
    let bobbin_v_x_dot_by_spring_stiffness = R::literal(-1.428_571_428_571_428_6) * t138;
    let rod_omega_dot_by_spring_stiffness = (t26 * t140)
        .sub_product(R::literal(4_166.666_666_666_667), t142).sub_product(t27, t139);
    let rod_v_y_dot_by_spring_stiffness = -t134.add_product(t25, t141).add_product(R::literal(5.0),
        t139);
    let rod_v_x_dot_by_spring_stiffness = (-t132).add_product(t24, t141)
        .sub_product(R::literal(5.0), t140);
    let cylinder_omega_dot_by_spring_stiffness = (-t129.add_product(t21, t144)).add_product(t22,
        t143).add_product(R::literal(2_777.777_777_777_778), t142).add_product(t23, t141);
    let cylinder_v_y_dot_by_spring_stiffness = t127
        .sub_product(R::literal(3.333_333_333_333_333_5), t143).add_product(t20, t141);
    let cylinder_v_x_dot_by_spring_stiffness = t125
        .sub_product(R::literal(3.333_333_333_333_333_5), t144).sub_product(t19, t141);
    let plate_omega_dot_by_spring_stiffness = (t16 * t145).sub_product(t15, t146).sub_product(t15,
        t144).add_product(t16, t143).add_product(t17, t138).sub_product(t18, t137);
    let plate_v_y_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t143)
        .sub_product(R::literal(0.833_333_333_333_333_4), t145)
        .add_product(R::literal(0.833_333_333_333_333_4), t137);
    let plate_v_x_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t144)
        .sub_product(R::literal(0.833_333_333_333_333_4), t146)
        .add_product(R::literal(0.833_333_333_333_333_4), t138);
    let post_omega_dot_by_spring_stiffness = (-(t14 * t147).add_product(t13, t148).add_product(t13,
        t146)).add_product(t14, t145);
    let post_v_y_dot_by_spring_stiffness = (R::literal(1.25) * t145).add_product(R::literal(1.25),
        t147);
    let post_v_x_dot_by_spring_stiffness = (R::literal(1.25) * t146).sub_product(R::literal(1.25),
        t148);
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let t149 = slide_rate * t9;
    let t150 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_cos_cylinder_phi;
    let t151 = (-t150).add_product(t21, t149);
    let t152 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_sin_cylinder_phi;
    let t153 = (-t152.add_product(t22, t149)).add_product(t70, t151);
    let t154 = R::literal(2_777.777_777_777_778) * t149;
    let t155 = (-t154).add_product(t71, t151).sub_product(t80, t153);
    let t156 = (t20 * slide_rate_times_sin_cylinder_phi).sub_product(t19,
        slide_rate_times_cos_cylinder_phi).sub_product(t23, t149).sub_product(t24,
        slide_rate_times_cos_cylinder_phi).add_product(t25, slide_rate_times_sin_cylinder_phi)
        .add_product(t73, t151).sub_product(t82, t153).sub_product(t89, t155);
    let t157 = R::literal(5.0) * slide_rate_times_cos_cylinder_phi;
    let t158 = t157.sub_product(t90, t155).sub_product(t98, t156);
    let t159 = R::literal(5.0) * slide_rate_times_sin_cylinder_phi;
    let t160 = t159.add_product(t91, t155).sub_product(t100, t156).add_product(t107, t158);
    let t161 = (t75 * t151).sub_product(t84, t153).sub_product(t93, t155).sub_product(t102, t156)
        .sub_product(t109, t158).sub_product(t114, t160);
    let t162 = (t77 * t151).sub_product(t86, t153).sub_product(t95, t155).sub_product(t104, t156)
        .sub_product(t111, t158).sub_product(t116, t160).sub_product(t119, t161) * t120;
    let t163 = (t161 * t117).sub_product(t119, t162);
    let t164 = (t160 * t112).sub_product(t114, t163).sub_product(t116, t162);
    let t165 = (-(t158 * t105)).add_product(t107, t164).sub_product(t109, t163).sub_product(t111,
        t162);
    let t166 = (t156 * t96).sub_product(t98, t165).sub_product(t100, t164).sub_product(t102, t163)
        .sub_product(t104, t162);
    let t167 = (t155 * t87).sub_product(t89, t166).sub_product(t90, t165).add_product(t91, t164)
        .sub_product(t93, t163).sub_product(t95, t162);
    let t168 = (t153 * t78).sub_product(t80, t167).sub_product(t82, t166).sub_product(t84, t163)
        .sub_product(t86, t162);
    let t169 = (-(t151 * t68)).add_product(t70, t168).add_product(t71, t167).add_product(t73, t166)
        .add_product(t75, t163).add_product(t77, t162);
    let t170 = (-(t61 * t168).add_product(t59, t169)).add_product(t64, t163).sub_product(t67, t162);
    let t171 = (-(t49 * t169).add_product(t47, t170).add_product(t50, t168).add_product(t53, t163))
        .add_product(t55, t162);
    let t172 = (t42 * t170).add_product(t40, t171);
    let t173 = (t34 * t171).sub_product(t32, t172).add_product(t32, t170);
    let bobbin_v_y_dot_by_spring_damping = R::literal(-1.428_571_428_571_428_6) * t162;
    let bobbin_v_x_dot_by_spring_damping = R::literal(-1.428_571_428_571_428_6) * t163;
    let rod_omega_dot_by_spring_damping = (t26 * t165)
        .sub_product(R::literal(4_166.666_666_666_667), t167).sub_product(t27, t164);
    let rod_v_y_dot_by_spring_damping = -t159.add_product(t25, t166).add_product(R::literal(5.0),
        t164);
    let rod_v_x_dot_by_spring_damping = (-t157).add_product(t24, t166).sub_product(R::literal(5.0),
        t165);
    let cylinder_omega_dot_by_spring_damping = (-t154.add_product(t21, t169)).add_product(t22, t168)
        .add_product(R::literal(2_777.777_777_777_778), t167).add_product(t23, t166);
    let cylinder_v_y_dot_by_spring_damping = t152.sub_product(R::literal(3.333_333_333_333_333_5),
        t168).add_product(t20, t166);
    let cylinder_v_x_dot_by_spring_damping = t150.sub_product(R::literal(3.333_333_333_333_333_5),
        t169).sub_product(t19, t166);
    let plate_omega_dot_by_spring_damping = (t16 * t170).sub_product(t15, t171).sub_product(t15,
        t169).add_product(t16, t168).add_product(t17, t163).sub_product(t18, t162);
    let plate_v_y_dot_by_spring_damping = (R::literal(0.833_333_333_333_333_4) * t168)
        .sub_product(R::literal(0.833_333_333_333_333_4), t170)
        .add_product(R::literal(0.833_333_333_333_333_4), t162);
    let plate_v_x_dot_by_spring_damping = (R::literal(0.833_333_333_333_333_4) * t169)
        .sub_product(R::literal(0.833_333_333_333_333_4), t171)
        .add_product(R::literal(0.833_333_333_333_333_4), t163);
    let post_omega_dot_by_spring_damping = (-(t14 * t172).add_product(t13, t173).add_product(t13,
        t171)).add_product(t14, t170);
    let post_v_y_dot_by_spring_damping = (R::literal(1.25) * t170).add_product(R::literal(1.25),
        t172);
    let post_v_x_dot_by_spring_damping = (R::literal(1.25) * t171).sub_product(R::literal(1.25),
        t173);
    let t174 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_gap * t7 / between));
    let t175 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_gap * t8 / between));
    let t176 = (-t175).add_product(t119, t174) * t120;
    let t177 = (t174 * t117).add_product(t119, t176);
    let t178 = (-(t116 * t176)).add_product(t114, t177);
    let t179 = (t109 * t177).add_product(t107, t178).sub_product(t111, t176);
    let t180 = (-(t100 * t178).add_product(t98, t179)).add_product(t102, t177).sub_product(t104,
        t176);
    let t181 = (-(t90 * t179).add_product(t89, t180)).add_product(t91, t178).add_product(t93, t177)
        .sub_product(t95, t176);
    let t182 = (-(t82 * t180).add_product(t80, t181)).add_product(t84, t177).sub_product(t86, t176);
    let t183 = (t71 * t181).add_product(t70, t182).add_product(t73, t180).sub_product(t75, t177)
        .add_product(t77, t176);
    let t184 = (t61 * t182).add_product(t59, t183).add_product(t64, t177).add_product(t67, t176);
    let t185 = (-(t49 * t183)).add_product(t47, t184).sub_product(t50, t182).add_product(t53, t177)
        .add_product(t55, t176);
    let t186 = (t42 * t184).sub_product(t40, t185);
    let t187 = (t34 * t185).add_product(t32, t186).sub_product(t32, t184);
    let bobbin_v_y_dot_by_contact_stiffness = t175.sub_product(R::literal(1.428_571_428_571_428_6),
        t176);
    let bobbin_v_x_dot_by_contact_stiffness = t174.add_product(R::literal(1.428_571_428_571_428_6),
        t177);
    let rod_omega_dot_by_contact_stiffness = (t26 * t179)
        .sub_product(R::literal(4_166.666_666_666_667), t181).sub_product(t27, t178);
    let rod_v_y_dot_by_contact_stiffness = -(R::literal(5.0) * t178).add_product(t25, t180);
    let rod_v_x_dot_by_contact_stiffness = (R::literal(-5.0) * t179).add_product(t24, t180);
    let cylinder_omega_dot_by_contact_stiffness = (t22 * t182).sub_product(t21, t183)
        .add_product(R::literal(2_777.777_777_777_778), t181).add_product(t23, t180);
    let cylinder_v_y_dot_by_contact_stiffness = (t20 * t180)
        .sub_product(R::literal(3.333_333_333_333_333_5), t182);
    let cylinder_v_x_dot_by_contact_stiffness = -(t19 * t180)
        .add_product(R::literal(3.333_333_333_333_333_5), t183);
    let plate_omega_dot_by_contact_stiffness = (-(t16 * t184).add_product(t15, t185)
        .add_product(t15, t183)).add_product(t16, t182).sub_product(t17, t177).sub_product(t18,
        t176);
    let plate_v_y_dot_by_contact_stiffness = (R::literal(0.833_333_333_333_333_4) * t182)
        .add_product(R::literal(0.833_333_333_333_333_4), t184)
        .add_product(R::literal(0.833_333_333_333_333_4), t176);
    let plate_v_x_dot_by_contact_stiffness = (R::literal(0.833_333_333_333_333_4) * t183)
        .sub_product(R::literal(0.833_333_333_333_333_4), t185)
        .sub_product(R::literal(0.833_333_333_333_333_4), t177);
    let post_omega_dot_by_contact_stiffness = (t14 * t186).sub_product(t13, t187).sub_product(t13,
        t185).sub_product(t14, t184);
    let post_v_y_dot_by_contact_stiffness = -(R::literal(1.25) * t184)
        .add_product(R::literal(1.25), t186);
    let post_v_x_dot_by_contact_stiffness = (R::literal(1.25) * t185).sub_product(R::literal(1.25),
        t187);
    let t188 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_rate * t7 / between));
    let t189 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_rate * t8 / between));
    let t190 = (-t189).add_product(t119, t188) * t120;
    let t191 = (t188 * t117).add_product(t119, t190);
    let t192 = (-(t116 * t190)).add_product(t114, t191);
    let t193 = (t109 * t191).add_product(t107, t192).sub_product(t111, t190);
    let t194 = (-(t100 * t192).add_product(t98, t193)).add_product(t102, t191).sub_product(t104,
        t190);
    let t195 = (-(t90 * t193).add_product(t89, t194)).add_product(t91, t192).add_product(t93, t191)
        .sub_product(t95, t190);
    let t196 = (-(t82 * t194).add_product(t80, t195)).add_product(t84, t191).sub_product(t86, t190);
    let t197 = (t71 * t195).add_product(t70, t196).add_product(t73, t194).sub_product(t75, t191)
        .add_product(t77, t190);
    let t198 = (t61 * t196).add_product(t59, t197).add_product(t64, t191).add_product(t67, t190);
    let t199 = (-(t49 * t197)).add_product(t47, t198).sub_product(t50, t196).add_product(t53, t191)
        .add_product(t55, t190);
    let t200 = (t42 * t198).sub_product(t40, t199);
    let t201 = (t34 * t199).add_product(t32, t200).sub_product(t32, t198);
    let bobbin_v_y_dot_by_contact_damping = t189.sub_product(R::literal(1.428_571_428_571_428_6),
        t190);
    let bobbin_v_x_dot_by_contact_damping = t188.add_product(R::literal(1.428_571_428_571_428_6),
        t191);
    let rod_omega_dot_by_contact_damping = (t26 * t193)
        .sub_product(R::literal(4_166.666_666_666_667), t195).sub_product(t27, t192);
    let rod_v_y_dot_by_contact_damping = -(R::literal(5.0) * t192).add_product(t25, t194);
    let rod_v_x_dot_by_contact_damping = (R::literal(-5.0) * t193).add_product(t24, t194);
    let cylinder_omega_dot_by_contact_damping = (t22 * t196).sub_product(t21, t197)
        .add_product(R::literal(2_777.777_777_777_778), t195).add_product(t23, t194);
    let cylinder_v_y_dot_by_contact_damping = (t20 * t194)
        .sub_product(R::literal(3.333_333_333_333_333_5), t196);
    let cylinder_v_x_dot_by_contact_damping = -(t19 * t194)
        .add_product(R::literal(3.333_333_333_333_333_5), t197);
    let plate_omega_dot_by_contact_damping = (-(t16 * t198).add_product(t15, t199).add_product(t15,
        t197)).add_product(t16, t196).sub_product(t17, t191).sub_product(t18, t190);
    let plate_v_y_dot_by_contact_damping = (R::literal(0.833_333_333_333_333_4) * t196)
        .add_product(R::literal(0.833_333_333_333_333_4), t198)
        .add_product(R::literal(0.833_333_333_333_333_4), t190);
    let plate_v_x_dot_by_contact_damping = (R::literal(0.833_333_333_333_333_4) * t197)
        .sub_product(R::literal(0.833_333_333_333_333_4), t199)
        .sub_product(R::literal(0.833_333_333_333_333_4), t191);
    let post_omega_dot_by_contact_damping = (t14 * t200).sub_product(t13, t201).sub_product(t13,
        t199).sub_product(t14, t198);
    let post_v_y_dot_by_contact_damping = -(R::literal(1.25) * t198).add_product(R::literal(1.25),
        t200);
    let post_v_x_dot_by_contact_damping = (R::literal(1.25) * t199).sub_product(R::literal(1.25),
        t201);
    [post_v_x_dot_by_spring_stiffness, post_v_x_dot_by_spring_damping,
        post_v_x_dot_by_contact_stiffness, post_v_x_dot_by_contact_damping,
        post_v_y_dot_by_spring_stiffness, post_v_y_dot_by_spring_damping,
        post_v_y_dot_by_contact_stiffness, post_v_y_dot_by_contact_damping,
        post_omega_dot_by_spring_stiffness, post_omega_dot_by_spring_damping,
        post_omega_dot_by_contact_stiffness, post_omega_dot_by_contact_damping,
        plate_v_x_dot_by_spring_stiffness, plate_v_x_dot_by_spring_damping,
        plate_v_x_dot_by_contact_stiffness, plate_v_x_dot_by_contact_damping,
        plate_v_y_dot_by_spring_stiffness, plate_v_y_dot_by_spring_damping,
        plate_v_y_dot_by_contact_stiffness, plate_v_y_dot_by_contact_damping,
        plate_omega_dot_by_spring_stiffness, plate_omega_dot_by_spring_damping,
        plate_omega_dot_by_contact_stiffness, plate_omega_dot_by_contact_damping,
        cylinder_v_x_dot_by_spring_stiffness, cylinder_v_x_dot_by_spring_damping,
        cylinder_v_x_dot_by_contact_stiffness, cylinder_v_x_dot_by_contact_damping,
        cylinder_v_y_dot_by_spring_stiffness, cylinder_v_y_dot_by_spring_damping,
        cylinder_v_y_dot_by_contact_stiffness, cylinder_v_y_dot_by_contact_damping,
        cylinder_omega_dot_by_spring_stiffness, cylinder_omega_dot_by_spring_damping,
        cylinder_omega_dot_by_contact_stiffness, cylinder_omega_dot_by_contact_damping,
        rod_v_x_dot_by_spring_stiffness, rod_v_x_dot_by_spring_damping,
        rod_v_x_dot_by_contact_stiffness, rod_v_x_dot_by_contact_damping,
        rod_v_y_dot_by_spring_stiffness, rod_v_y_dot_by_spring_damping,
        rod_v_y_dot_by_contact_stiffness, rod_v_y_dot_by_contact_damping,
        rod_omega_dot_by_spring_stiffness, rod_omega_dot_by_spring_damping,
        rod_omega_dot_by_contact_stiffness, rod_omega_dot_by_contact_damping,
        bobbin_v_x_dot_by_spring_stiffness, bobbin_v_x_dot_by_spring_damping,
        bobbin_v_x_dot_by_contact_stiffness, bobbin_v_x_dot_by_contact_damping,
        bobbin_v_y_dot_by_spring_stiffness, bobbin_v_y_dot_by_spring_damping,
        bobbin_v_y_dot_by_contact_stiffness, bobbin_v_y_dot_by_contact_damping]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 52 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _,
        bobbin_x, bobbin_y, _, _, post_omega, _, _, _, cylinder_v_x, cylinder_v_y, cylinder_omega,
        rod_v_x, rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_cylinder_phi, cos_cylinder_phi)]
        = R::sin_cos_each([post_phi, cylinder_phi]);
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let stop_rate = post_omega * (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143),
        cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let stop_push = -(R::literal(1_000_000.0) * stop_gap).add_product(R::literal(1500.0),
        stop_rate);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega,
        (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi)).add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_push = -(p.contact_stiffness * contact_gap).add_product(p.contact_damping,
        contact_rate);
    Outputs {
        contact_force: R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
            contact_push),
        stop_force: R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), stop_push),
        contact_gap,
        stop_gap,
        strut_push: -(p.spring_stiffness * (slide - R::literal(0.116)))
            .add_product(p.spring_damping, slide_rate),
        post_angle: post_phi,
        plate_angle: plate_phi,
    }
}

/// T, V and the energy of first-order states \[J\]. 78 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, post_y, post_phi, _, plate_y, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _,
        bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y, plate_omega,
        cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x,
        bobbin_v_y, contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_cylinder_phi, cos_cylinder_phi)]
        = R::sin_cos_each([post_phi, cylinder_phi]);
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let t2 = slide - R::literal(0.116);
    Energy {
        kinetic: (R::literal(0.00012) * (rod_omega * rod_omega)).add_product(R::literal(0.00018),
            cylinder_omega * cylinder_omega).add_product(R::literal(0.00125), plate_omega
            * plate_omega).add_product(R::literal(0.00135), post_omega * post_omega)
            .add_product(R::literal(0.1), (rod_v_x * rod_v_x).add_product(rod_v_y, rod_v_y))
            .add_product(R::literal(0.15), (cylinder_v_x * cylinder_v_x).add_product(cylinder_v_y,
            cylinder_v_y)).add_product(R::literal(0.35), (bobbin_v_x * bobbin_v_x)
            .add_product(bobbin_v_y, bobbin_v_y)).add_product(R::literal(0.4), (post_v_x * post_v_x)
            .add_product(post_v_y, post_v_y)).add_product(R::literal(0.6), (plate_v_x * plate_v_x)
            .add_product(plate_v_y, plate_v_y)),
        potential: (R::literal(1.962) * rod_y).add_product(R::literal(0.5) * p.spring_stiffness, t2
            * t2).add_product(R::literal(2.943), cylinder_y).add_product(R::literal(6.867),
            bobbin_y).add_product(R::literal(7.848), post_y).add_product(R::literal(11.772),
            plate_y) + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
            R::literal(0.5) * p.contact_stiffness * (contact_gap * contact_gap))
            + R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(500_000.0)
            * (stop_gap * stop_gap)),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 820 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y,
        plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
        bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let t1 = R::literal(0.1) * sin_post_phi;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * sin_rod_phi;
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let t7 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8).add_product(t9, t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t9) / between;
    let t10 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t10)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t11 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t12 = R::literal(0.01) * t11;
    let t13 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t14 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t15 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t16 = R::literal(24.0) * sin_plate_phi;
    let t17 = R::literal(24.0) * cos_plate_phi;
    let t18 = R::literal(4.0) * t11;
    let t19 = t13 * R::literal(400.0);
    let t20 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t22 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t23 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t24 = slide * R::literal(2_777.777_777_777_778);
    let t25 = sin_cylinder_phi * R::literal(5.0);
    let t26 = cos_cylinder_phi * R::literal(5.0);
    let t27 = R::literal(250.0) * sin_rod_phi;
    let t28 = R::literal(250.0) * cos_rod_phi;
    let t29 = t14 * t1;
    let t30 = R::literal(1.25) + t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t15 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t15 * t0;
    let t37 = R::literal(1.25) + t36;
    let t38 = t33 * t32;
    let t39 = R::literal(1.0) / (t38 - t37);
    let t40 = (t14 * t0).add_product(t35, t32);
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t36 + t38;
    let t43 = t42 * t39;
    let t44 = t16 * t3;
    let t45 = R::literal(1.0) / (-(t30 + R::literal(0.833_333_333_333_333_4) + t44))
        .add_product(t35, t34).sub_product(t41, t40);
    let t46 = t17 * t3;
    let t47 = (t32 + t46).add_product(t33, t34).sub_product(t43, t40);
    let t48 = t47 * t45;
    let t49 = R::literal(0.833_333_333_333_333_4) - t44;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t18 * t3;
    let t53 = R::literal(0.833_333_333_333_333_4) + t52;
    let t54 = t53 * t45;
    let t55 = t19 * t3;
    let t56 = t55 * t45;
    let t57 = t17 * t2;
    let t58 = R::literal(1.0) / (t38 - (t37 + R::literal(0.833_333_333_333_333_4) + t57))
        .sub_product(t43, t42).sub_product(t48, t47);
    let t59 = (t16 * t2).sub_product(t50, t47);
    let t60 = t59 * t58;
    let t61 = (R::literal(0.833_333_333_333_333_4) - t57).sub_product(t51, t47);
    let t62 = t61 * t58;
    let t63 = t18 * t2;
    let t64 = t63.add_product(t54, t47);
    let t65 = t64 * t58;
    let t66 = t19 * t2;
    let t67 = (R::literal(0.833_333_333_333_333_4) + t66).add_product(t56, t47);
    let t68 = t67 * t58;
    let t69 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t44
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t5).add_product(t50, t49)
        .add_product(t60, t59);
    let t70 = t46.add_product(t23, t5).sub_product(t51, t49).sub_product(t62, t59);
    let t71 = t70 * t69;
    let t72 = t22 * t69;
    let t73 = (-t20).add_product(t24, t5);
    let t74 = t73 * t69;
    let t75 = (t52 - R::literal(0.833_333_333_333_333_4)).sub_product(t54, t49).add_product(t65,
        t59);
    let t76 = t75 * t69;
    let t77 = (-t55).add_product(t56, t49).sub_product(t68, t59);
    let t78 = t77 * t69;
    let t79 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t57
        + R::literal(3.333_333_333_333_333_5)).add_product(t23, t4).add_product(t51, t46)
        .add_product(t62, t61)).add_product(t71, t70);
    let t80 = (-t23).add_product(t72, t70);
    let t81 = t80 * t79;
    let t82 = t21.sub_product(t24, t4).add_product(t74, t70);
    let t83 = t82 * t79;
    let t84 = (-t63.add_product(t54, t46)).add_product(t65, t61).add_product(t76, t70);
    let t85 = t84 * t79;
    let t86 = (t66 - R::literal(0.833_333_333_333_333_4)).add_product(t56, t46).sub_product(t68,
        t61).add_product(t78, t70);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t72, t22)
        .sub_product(t81, t80);
    let t89 = (-t24).add_product(t74, t22).sub_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t27 * t88;
    let t92 = t28 * t88;
    let t93 = (t76 * t22).sub_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t22).sub_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0) / (-(t20 * sin_cylinder_phi).add_product(t21, cos_cylinder_phi)
        .add_product(t24, slide).add_product(t25, sin_cylinder_phi).add_product(t26,
        cos_cylinder_phi)).add_product(t74, t73).sub_product(t83, t82).sub_product(t90, t89);
    let t98 = t25.sub_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = (-t26).add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (t76 * t73).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (t78 * t73).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / R::literal(5.0).add_product(t27, t6).add_product(t91, t27)
        .add_product(t99, t98);
    let t107 = (t28 * t6).add_product(t92, t27).sub_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (t94 * t27).add_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (t96 * t27).add_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0) / (-R::literal(5.0).add_product(t28, R::literal(0.06) * cos_rod_phi)
        .add_product(t92, t28).add_product(t101, t100)).add_product(t108, t107);
    let t114 = (t94 * t28).sub_product(t103, t100).sub_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (t96 * t28).sub_product(t105, t100).sub_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t12)
        + R::literal(1.428_571_428_571_428_6)).add_product(t54, t53).add_product(t65, t64))
        .add_product(t76, t75).sub_product(t85, t84).sub_product(t94, t93).sub_product(t103, t102)
        .add_product(t110, t109).sub_product(t115, t114);
    let t119 = (t19 * t12).add_product(t56, t53).add_product(t68, t64).add_product(t78, t75)
        .sub_product(t87, t84).sub_product(t96, t93).sub_product(t105, t102).add_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::literal(1_000_000.0) * stop_gap * t7;
    let t122 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), -t121
        .add_product(R::literal(1500.0) * stop_rate, t7));
    let t123 = p.spring_stiffness * (slide - R::literal(0.116));
    let t124 = t123 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t125 = t124.add_product(spring_damping_times_slide_rate, cos_cylinder_phi);
    let t126 = t123 * sin_cylinder_phi;
    let t127 = R::literal(2.943) - t126;
    let t128 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t129 = t128 - t127;
    let t130 = t123 * t10;
    let t131 = t130.add_product(spring_damping_times_slide_rate, t10);
    let t132 = R::literal(1.962) + t126;
    let t133 = t128 + t132;
    let t134 = contact_stiffness_times_contact_gap * t8 / between;
    let t135 = R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t9 / between);
    let t136 = R::literal(0.1) * (post_omega * post_omega);
    let t137 = t136 * cos_post_phi;
    let t138 = t136 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t139 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t140 = R::literal(0.06) * (rod_omega * rod_omega);
    let t141 = t14 * t122;
    let t142 = t137 + t141;
    let t143 = t15 * t122;
    let t144 = t33 * t142;
    let t145 = R::literal(9.81) - t138 + t143 - t144;
    let t146 = (t137.add_product(t139, cos_plate_phi) + t141).add_product(t35, t142)
        .add_product(t41, t145);
    let t147 = (t143 - (t138.add_product(t139, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) - t144).sub_product(t43, t145).add_product(t48, t146);
    let t148 = R::literal(3.333_333_333_333_333_5) * t125;
    let t149 = (-t148.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))).add_product(t22, t131)
        .add_product(t50, t146).sub_product(t60, t147);
    let t150 = R::literal(3.333_333_333_333_333_5) * t129;
    let t151 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t150)
        .add_product(t23, t131)).add_product(t51, t146).sub_product(t62, t147).add_product(t71,
        t149);
    let t152 = R::literal(2_777.777_777_777_778) * t131;
    let t153 = (-t152).add_product(t72, t149).sub_product(t81, t151);
    let t154 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t20, t125)
        .add_product(t21, t129).sub_product(t24, t131).sub_product(t25, t125).add_product(t26, t133)
        .add_product(t74, t149).sub_product(t83, t151);
    let t155 = t154.sub_product(t90, t153);
    let t156 = R::literal(5.0) * t125;
    let t157 = t156.add_product(t140, cos_rod_phi).sub_product(t91, t153).sub_product(t99, t155);
    let t158 = R::literal(5.0) * t133;
    let t159 = t158.add_product(t140, sin_rod_phi).add_product(t92, t153).sub_product(t101, t155)
        .add_product(t108, t157);
    let t160 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t134 + contact_damping_times_contact_rate * t8
        / between));
    let t161 = (-t160).add_product(t13, plate_omega_squared).add_product(t54, t146)
        .add_product(t65, t147).add_product(t76, t149).sub_product(t85, t151).sub_product(t94, t153)
        .sub_product(t103, t155).sub_product(t110, t157).sub_product(t115, t159);
    let t162 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_damping_times_contact_rate * t9 / between))
        - t135);
    let t163 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared) - t162).sub_product(t56,
        t146).sub_product(t68, t147).add_product(t78, t149).sub_product(t87, t151).sub_product(t96,
        t153).sub_product(t105, t155).sub_product(t112, t157).sub_product(t117, t159)
        .sub_product(t120, t161);
    let t164 = t163 * (R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t19,
        t13) + R::literal(1.428_571_428_571_428_6)).add_product(t56, t55).add_product(t68, t67))
        .add_product(t78, t77).sub_product(t87, t86).sub_product(t96, t95).sub_product(t105, t104)
        .add_product(t112, t111).sub_product(t117, t116).sub_product(t120, t119));
    let t165 = (t161 * t118).sub_product(t120, t164);
    let t166 = (t159 * t113).sub_product(t115, t165).sub_product(t117, t164);
    let t167 = (-(t157 * t106)).add_product(t108, t166).sub_product(t110, t165).sub_product(t112,
        t164);
    let t168 = (t155 * t97).sub_product(t99, t167).sub_product(t101, t166).sub_product(t103, t165)
        .sub_product(t105, t164);
    let t169 = (t153 * t88).sub_product(t90, t168).sub_product(t91, t167).add_product(t92, t166)
        .sub_product(t94, t165).sub_product(t96, t164);
    let t170 = (t151 * t79).sub_product(t81, t169).sub_product(t83, t168).sub_product(t85, t165)
        .sub_product(t87, t164);
    let t171 = (-(t149 * t69)).add_product(t71, t170).add_product(t72, t169).add_product(t74, t168)
        .add_product(t76, t165).add_product(t78, t164);
    let t172 = (t147 * t58).sub_product(t60, t171).sub_product(t62, t170).add_product(t65, t165)
        .sub_product(t68, t164);
    let t173 = (-(t146 * t45).add_product(t48, t172).add_product(t50, t171).add_product(t51, t170)
        .add_product(t54, t165)).add_product(t56, t164);
    let t174 = (t145 * t39).sub_product(t41, t173).sub_product(t43, t172);
    let t175 = (t142 * t31).add_product(t33, t174).add_product(t35, t173).add_product(t33, t172);
    let bobbin_v_y_dot = t162.sub_product(R::literal(1.428_571_428_571_428_6), t164);
    let bobbin_v_x_dot = t160.sub_product(R::literal(1.428_571_428_571_428_6), t165);
    let rod_omega_dot = (t27 * t167).sub_product(R::literal(4_166.666_666_666_667), t169)
        .sub_product(t28, t166);
    let rod_v_x_dot = (-t156).add_product(t25, t168).sub_product(R::literal(5.0), t167);
    let cylinder_omega_dot = (-t152.add_product(t22, t171)).add_product(t23, t170)
        .add_product(R::literal(2_777.777_777_777_778), t169).add_product(t24, t168);
    let cylinder_v_y_dot = t150.sub_product(R::literal(3.333_333_333_333_333_5), t170)
        .add_product(t21, t168);
    let cylinder_v_x_dot = t148.sub_product(R::literal(3.333_333_333_333_333_5), t171)
        .sub_product(t20, t168);
    let plate_omega_dot = (t17 * t172).sub_product(t16, t173).sub_product(t16, t171)
        .add_product(t17, t170).add_product(t18, t165).sub_product(t19, t164);
    let plate_v_y_dot = (-R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t172))
        .add_product(R::literal(0.833_333_333_333_333_4), t170)
        .add_product(R::literal(0.833_333_333_333_333_4), t164);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t171)
        .sub_product(R::literal(0.833_333_333_333_333_4), t173)
        .add_product(R::literal(0.833_333_333_333_333_4), t165);
    let post_omega_dot = (t122 * R::literal(370.370_370_370_370_3)).sub_product(t14, t175)
        .add_product(t15, t174).sub_product(t14, t173).add_product(t15, t172);
    let post_v_y_dot = (-R::literal(9.81).add_product(R::literal(1.25), t174))
        .add_product(R::literal(1.25), t172);
    let post_v_x_dot = (R::literal(1.25) * t173).sub_product(R::literal(1.25), t175);
    let t176 = (R::literal(7.848) * post_v_y).add_product(R::select_less(stop_closed,
        R::literal(0.5), R::literal(0.0), t121), post_omega).add_product(R::literal(11.772),
        plate_v_y).sub_product(t124, cylinder_v_x).add_product(t127, cylinder_v_y)
        .add_product(t130, cylinder_omega).add_product(t124, rod_v_x).add_product(t132, rod_v_y)
        .add_product(R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t134),
        bobbin_v_x).add_product(t135, bobbin_v_y).add_product(R::literal(0.8) * post_v_x,
        post_v_x_dot).add_product(R::literal(0.8) * post_v_y, post_v_y_dot)
        .add_product(R::literal(0.0027) * post_omega, post_omega_dot).add_product(R::literal(1.2)
        * plate_v_x, plate_v_x_dot).add_product(R::literal(1.2) * plate_v_y, plate_v_y_dot)
        .add_product(R::literal(0.0025) * plate_omega, plate_omega_dot);
    let t177 = (p.spring_damping * cylinder_omega * slide_rate * t10).add_product(p.spring_damping
        * rod_v_x * slide_rate, cos_cylinder_phi).add_product(p.spring_damping * rod_v_y
        * slide_rate, sin_cylinder_phi) + R::select_less(contact_closed, R::literal(0.5),
        R::literal(0.0), p.contact_damping * bobbin_v_x * contact_rate * t8 / between
        + p.contact_damping * bobbin_v_y * contact_rate * t9 / between)
        + R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(1500.0)
        * (stop_rate * stop_rate));
    PowerBalance {
        stored_rate: t176.add_product(R::literal(0.3) * cylinder_v_x, cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot).sub_product(R::literal(0.2)
            * rod_v_y, t158.add_product(t26, t168).add_product(R::literal(5.0), t166))
            .add_product(R::literal(0.00024) * rod_omega, rod_omega_dot)
            .add_product(R::literal(0.7) * bobbin_v_x, bobbin_v_x_dot).add_product(R::literal(0.7)
            * bobbin_v_y, bobbin_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: t177.sub_product(p.spring_damping * cylinder_v_x * slide_rate, cos_cylinder_phi)
            .sub_product(p.spring_damping * cylinder_v_y * slide_rate, sin_cylinder_phi),
    }
}

/// What passes zero where events happen, one for each event. 28 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let post_phi = state[2];
    let bobbin_x = state[12];
    let bobbin_y = state[13];
    let post_omega = state[16];
    let bobbin_v_x = state[26];
    let bobbin_v_y = state[27];
    let (sin_post_phi, cos_post_phi) = post_phi.sin_cos();
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let stop_rate = post_omega * (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143),
        cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let stop_push = -(R::literal(1_000_000.0) * stop_gap).add_product(R::literal(1500.0),
        stop_rate);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let contact_push = -(p.contact_stiffness * contact_gap).add_product(p.contact_damping,
        contact_rate);
    [contact_gap, contact_push, stop_gap, stop_push]
}

/// `dg/dt` of the guards along the motion. 709 operations.
#[must_use]
pub fn guard_rates<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, _, post_omega, _, _, plate_omega, cylinder_v_x,
        cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y,
        contact_closed, stop_closed] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let t1 = R::literal(0.1) * sin_post_phi;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * sin_rod_phi;
    let stop_gap = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi);
    let t7 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8).add_product(t9, t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t9) / between;
    let t10 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t10)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t11 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t12 = R::literal(0.01) * t11;
    let t13 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t14 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t15 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t16 = R::literal(24.0) * sin_plate_phi;
    let t17 = R::literal(24.0) * cos_plate_phi;
    let t18 = R::literal(4.0) * t11;
    let t19 = t13 * R::literal(400.0);
    let t20 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t22 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t23 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t24 = slide * R::literal(2_777.777_777_777_778);
    let t25 = sin_cylinder_phi * R::literal(5.0);
    let t26 = cos_cylinder_phi * R::literal(5.0);
    let t27 = R::literal(250.0) * sin_rod_phi;
    let t28 = R::literal(250.0) * cos_rod_phi;
    let t29 = t14 * t1;
    let t30 = R::literal(1.25) + t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t15 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t15 * t0;
    let t37 = R::literal(1.25) + t36;
    let t38 = t33 * t32;
    let t39 = R::literal(1.0) / (t38 - t37);
    let t40 = (t14 * t0).add_product(t35, t32);
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t36 + t38;
    let t43 = t42 * t39;
    let t44 = t16 * t3;
    let t45 = R::literal(1.0) / (-(t30 + R::literal(0.833_333_333_333_333_4) + t44))
        .add_product(t35, t34).sub_product(t41, t40);
    let t46 = t17 * t3;
    let t47 = (t32 + t46).add_product(t33, t34).sub_product(t43, t40);
    let t48 = t47 * t45;
    let t49 = R::literal(0.833_333_333_333_333_4) - t44;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t18 * t3;
    let t53 = R::literal(0.833_333_333_333_333_4) + t52;
    let t54 = t53 * t45;
    let t55 = t19 * t3;
    let t56 = t55 * t45;
    let t57 = t17 * t2;
    let t58 = R::literal(1.0) / (t38 - (t37 + R::literal(0.833_333_333_333_333_4) + t57))
        .sub_product(t43, t42).sub_product(t48, t47);
    let t59 = (t16 * t2).sub_product(t50, t47);
    let t60 = t59 * t58;
    let t61 = (R::literal(0.833_333_333_333_333_4) - t57).sub_product(t51, t47);
    let t62 = t61 * t58;
    let t63 = t18 * t2;
    let t64 = t63.add_product(t54, t47);
    let t65 = t64 * t58;
    let t66 = t19 * t2;
    let t67 = (R::literal(0.833_333_333_333_333_4) + t66).add_product(t56, t47);
    let t68 = t67 * t58;
    let t69 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t44
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t5).add_product(t50, t49)
        .add_product(t60, t59);
    let t70 = t46.add_product(t23, t5).sub_product(t51, t49).sub_product(t62, t59);
    let t71 = t70 * t69;
    let t72 = t22 * t69;
    let t73 = (-t20).add_product(t24, t5);
    let t74 = t73 * t69;
    let t75 = (t52 - R::literal(0.833_333_333_333_333_4)).sub_product(t54, t49).add_product(t65,
        t59);
    let t76 = t75 * t69;
    let t77 = (-t55).add_product(t56, t49).sub_product(t68, t59);
    let t78 = t77 * t69;
    let t79 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t57
        + R::literal(3.333_333_333_333_333_5)).add_product(t23, t4).add_product(t51, t46)
        .add_product(t62, t61)).add_product(t71, t70);
    let t80 = (-t23).add_product(t72, t70);
    let t81 = t80 * t79;
    let t82 = t21.sub_product(t24, t4).add_product(t74, t70);
    let t83 = t82 * t79;
    let t84 = (-t63.add_product(t54, t46)).add_product(t65, t61).add_product(t76, t70);
    let t85 = t84 * t79;
    let t86 = (t66 - R::literal(0.833_333_333_333_333_4)).add_product(t56, t46).sub_product(t68,
        t61).add_product(t78, t70);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t72, t22)
        .sub_product(t81, t80);
    let t89 = (-t24).add_product(t74, t22).sub_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t27 * t88;
    let t92 = t28 * t88;
    let t93 = (t76 * t22).sub_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t22).sub_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0) / (-(t20 * sin_cylinder_phi).add_product(t21, cos_cylinder_phi)
        .add_product(t24, slide).add_product(t25, sin_cylinder_phi).add_product(t26,
        cos_cylinder_phi)).add_product(t74, t73).sub_product(t83, t82).sub_product(t90, t89);
    let t98 = t25.sub_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = (-t26).add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (t76 * t73).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (t78 * t73).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / R::literal(5.0).add_product(t27, t6).add_product(t91, t27)
        .add_product(t99, t98);
    let t107 = (t28 * t6).add_product(t92, t27).sub_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (t94 * t27).add_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (t96 * t27).add_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0) / (-R::literal(5.0).add_product(t28, R::literal(0.06) * cos_rod_phi)
        .add_product(t92, t28).add_product(t101, t100)).add_product(t108, t107);
    let t114 = (t94 * t28).sub_product(t103, t100).sub_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (t96 * t28).sub_product(t105, t100).sub_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t12)
        + R::literal(1.428_571_428_571_428_6)).add_product(t54, t53).add_product(t65, t64))
        .add_product(t76, t75).sub_product(t85, t84).sub_product(t94, t93).sub_product(t103, t102)
        .add_product(t110, t109).sub_product(t115, t114);
    let t119 = (t19 * t12).add_product(t56, t53).add_product(t68, t64).add_product(t78, t75)
        .sub_product(t87, t84).sub_product(t96, t93).sub_product(t105, t102).add_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t7).add_product(R::literal(1500.0) * stop_rate, t7));
    let t122 = p.spring_stiffness * (slide - R::literal(0.116));
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t123 = (t122 * cos_cylinder_phi).add_product(spring_damping_times_slide_rate,
        cos_cylinder_phi);
    let t124 = t122 * sin_cylinder_phi;
    let t125 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t126 = t125 - (R::literal(2.943) - t124);
    let t127 = (t122 * t10).add_product(spring_damping_times_slide_rate, t10);
    let t128 = t125 + (R::literal(1.962) + t124);
    let t129 = contact_damping_times_contact_rate * t8;
    let t130 = contact_damping_times_contact_rate * t9;
    let t131 = R::literal(0.1) * (post_omega * post_omega);
    let t132 = t131 * cos_post_phi;
    let t133 = t131 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t134 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t135 = R::literal(0.06) * (rod_omega * rod_omega);
    let t136 = t14 * t121;
    let t137 = t132 + t136;
    let t138 = t15 * t121;
    let t139 = t33 * t137;
    let t140 = R::literal(9.81) - t133 + t138 - t139;
    let t141 = (t132.add_product(t134, cos_plate_phi) + t136).add_product(t35, t137)
        .add_product(t41, t140);
    let t142 = (t138 - (t133.add_product(t134, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) - t139).sub_product(t43, t140).add_product(t48, t141);
    let t143 = (-(R::literal(0.06) * (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .add_product(R::literal(3.333_333_333_333_333_5), t123)).add_product(t22, t127)
        .add_product(t50, t141).sub_product(t60, t142);
    let t144 = (-R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi))
        .add_product(R::literal(3.333_333_333_333_333_5), t126).add_product(t23, t127))
        .add_product(t51, t141).sub_product(t62, t142).add_product(t71, t143);
    let t145 = (R::literal(-2_777.777_777_777_778) * t127).add_product(t72, t143).sub_product(t81,
        t144);
    let t146 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t20, t123)
        .add_product(t21, t126).sub_product(t24, t127).sub_product(t25, t123).add_product(t26, t128)
        .add_product(t74, t143).sub_product(t83, t144);
    let t147 = t146.sub_product(t90, t145);
    let t148 = (t135 * cos_rod_phi).add_product(R::literal(5.0), t123).sub_product(t91, t145)
        .sub_product(t99, t147);
    let t149 = (t135 * sin_rod_phi).add_product(R::literal(5.0), t128).add_product(t92, t145)
        .sub_product(t101, t147).add_product(t108, t148);
    let t150 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_stiffness_times_contact_gap * t8 / between
        + t129 / between));
    let t151 = (-t150).add_product(t13, plate_omega_squared).add_product(t54, t141)
        .add_product(t65, t142).add_product(t76, t143).sub_product(t85, t144).sub_product(t94, t145)
        .sub_product(t103, t147).sub_product(t110, t148).sub_product(t115, t149);
    let t152 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t130 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t9 / between)));
    let t153 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared) - t152).sub_product(t56,
        t141).sub_product(t68, t142).add_product(t78, t143).sub_product(t87, t144).sub_product(t96,
        t145).sub_product(t105, t147).sub_product(t112, t148).sub_product(t117, t149)
        .sub_product(t120, t151);
    let t154 = t153 * (R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t19,
        t13) + R::literal(1.428_571_428_571_428_6)).add_product(t56, t55).add_product(t68, t67))
        .add_product(t78, t77).sub_product(t87, t86).sub_product(t96, t95).sub_product(t105, t104)
        .add_product(t112, t111).sub_product(t117, t116).sub_product(t120, t119));
    let t155 = (t151 * t118).sub_product(t120, t154);
    let t156 = (t149 * t113).sub_product(t115, t155).sub_product(t117, t154);
    let t157 = (-(t148 * t106)).add_product(t108, t156).sub_product(t110, t155).sub_product(t112,
        t154);
    let t158 = (t147 * t97).sub_product(t99, t157).sub_product(t101, t156).sub_product(t103, t155)
        .sub_product(t105, t154);
    let t159 = (t145 * t88).sub_product(t90, t158).sub_product(t91, t157).add_product(t92, t156)
        .sub_product(t94, t155).sub_product(t96, t154);
    let t160 = (t144 * t79).sub_product(t81, t159).sub_product(t83, t158).sub_product(t85, t155)
        .sub_product(t87, t154);
    let t161 = (-(t143 * t69)).add_product(t71, t160).add_product(t72, t159).add_product(t74, t158)
        .add_product(t76, t155).add_product(t78, t154);
    let t162 = (t142 * t58).sub_product(t60, t161).sub_product(t62, t160).add_product(t65, t155)
        .sub_product(t68, t154);
    let t163 = (-(t141 * t45).add_product(t48, t162).add_product(t50, t161).add_product(t51, t160)
        .add_product(t54, t155)).add_product(t56, t154);
    let t164 = (t140 * t39).sub_product(t41, t163).sub_product(t43, t162);
    let bobbin_v_y_dot = t152.sub_product(R::literal(1.428_571_428_571_428_6), t154);
    let bobbin_v_x_dot = t150.sub_product(R::literal(1.428_571_428_571_428_6), t155);
    let post_omega_dot = (t121 * R::literal(370.370_370_370_370_3)).sub_product(t14, (t137 * t31)
        .add_product(t33, t164).add_product(t35, t163).add_product(t33, t162)).add_product(t15,
        t164).sub_product(t14, t163).add_product(t15, t162);
    let between_squared = between * between;
    let contact_touches_guard_rate = (t8 / between * bobbin_v_x).add_product(t9 / between,
        bobbin_v_y);
    let contact_opens_guard_rate = ((t129 / between_squared - p.contact_damping * bobbin_v_x
        / between - p.contact_stiffness * t8 / between) * bobbin_v_x).add_product(t130
        / between_squared - p.contact_damping * bobbin_v_y / between - p.contact_stiffness * t9
        / between, bobbin_v_y).sub_product(p.contact_damping * t8 / between, bobbin_v_x_dot)
        .sub_product(p.contact_damping * t9 / between, bobbin_v_y_dot);
    let stop_opens_guard_rate = ((R::literal(214.5) * post_omega * sin_post_phi)
        .sub_product(R::literal(143_000.0), cos_post_phi).sub_product(R::literal(44000.0),
        sin_post_phi).sub_product(R::literal(66.0) * post_omega, cos_post_phi) * post_omega)
        .sub_product(R::literal(1500.0) * t7, post_omega_dot);
    [contact_touches_guard_rate, contact_opens_guard_rate, stop_rate, stop_opens_guard_rate]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. No operations.
#[must_use]
pub fn resets<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; RESETS] {
    [R::literal(1.0), R::literal(0.0), R::literal(1.0), R::literal(0.0)]
}

/// `g` of each constraint, zero for those of velocities alone. 49 operations.
#[must_use]
pub fn constraint_values<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [post_x, post_y, post_phi, plate_x, plate_y, plate_phi, cylinder_x, cylinder_y,
        cylinder_phi, rod_x, rod_y, rod_phi, bobbin_x, bobbin_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let post_start_x = post_x - t0;
    let t1 = R::literal(0.1) * sin_post_phi;
    let post_start_y = post_y - t1;
    let post_end_x = post_x + t0;
    let post_end_y = post_y + t1;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let plate_start_x = plate_x - t2;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let plate_start_y = plate_y - t3;
    let plate_end_x = plate_x + t2;
    let plate_end_y = plate_y + t3;
    let cylinder_start_x = cylinder_x.sub_product(R::literal(0.06), cos_cylinder_phi);
    let cylinder_start_y = cylinder_y.sub_product(R::literal(0.06), sin_cylinder_phi);
    let rod_end_x = rod_x.add_product(R::literal(0.06), cos_rod_phi);
    let rod_end_y = rod_y.add_product(R::literal(0.06), sin_rod_phi);
    let axle_x = plate_x.add_product(R::literal(0.1), sin_plate_phi).sub_product(R::literal(0.01),
        cos_plate_phi);
    let axle_y = plate_y.sub_product(R::literal(0.1), cos_plate_phi).sub_product(R::literal(0.01),
        sin_plate_phi);
    let slide_across_value = ((rod_y - cylinder_y) * cos_cylinder_phi).sub_product(rod_x
        - cylinder_x, sin_cylinder_phi);
    let pin_c_x_value = plate_start_x - post_end_x;
    let pin_c_y_value = plate_start_y - post_end_y;
    let pin_d_x_value = cylinder_start_x - plate_end_x;
    let pin_d_y_value = cylinder_start_y - plate_end_y;
    let slide_angle_value = rod_phi - cylinder_phi;
    let pin_e_y_value = rod_end_y - R::literal(0.28);
    let axle_a_x_value = bobbin_x - axle_x;
    let axle_a_y_value = bobbin_y - axle_y;
    [post_start_x, post_start_y, pin_c_x_value, pin_c_y_value, pin_d_x_value, pin_d_y_value,
        slide_angle_value, slide_across_value, rod_end_x, pin_e_y_value, axle_a_x_value,
        axle_a_y_value]
}

/// `g'` of each constraint. 63 operations.
#[must_use]
pub fn constraint_rates<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, _, _, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y, plate_omega,
        cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x,
        bobbin_v_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let t0 = R::literal(0.1) * post_omega;
    let t1 = t0 * sin_post_phi;
    let pin_o_x_rate = post_v_x + t1;
    let t2 = t0 * cos_post_phi;
    let pin_o_y_rate = post_v_y - t2;
    let t3 = R::literal(0.06) * plate_omega;
    let t4 = t3 * sin_plate_phi;
    let pin_c_x_rate = plate_v_x + t4 + t1 - post_v_x;
    let t5 = t3 * cos_plate_phi;
    let pin_c_y_rate = plate_v_y - post_v_y - t2 - t5;
    let t6 = R::literal(0.06) * cylinder_omega;
    let pin_d_x_rate = (cylinder_v_x + t4).add_product(t6, sin_cylinder_phi) - plate_v_x;
    let pin_d_y_rate = (cylinder_v_y - plate_v_y - t5).sub_product(t6, cos_cylinder_phi);
    let slide_angle_rate = rod_omega - cylinder_omega;
    let slide_across_rate = (cylinder_v_x * sin_cylinder_phi).add_product(rod_v_y, cos_cylinder_phi)
        .sub_product(cylinder_v_y, cos_cylinder_phi).sub_product(cylinder_omega, slide)
        .sub_product(rod_v_x, sin_cylinder_phi);
    let t7 = R::literal(0.06) * rod_omega;
    let pin_e_x_rate = rod_v_x.sub_product(t7, sin_rod_phi);
    let pin_e_y_rate = rod_v_y.add_product(t7, cos_rod_phi);
    let axle_a_x_rate = (bobbin_v_x - plate_v_x).sub_product(plate_omega, (R::literal(0.01)
        * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi));
    let axle_a_y_rate = (bobbin_v_y - plate_v_y).sub_product(plate_omega, (R::literal(0.1)
        * sin_plate_phi).sub_product(R::literal(0.01), cos_plate_phi));
    [pin_o_x_rate, pin_o_y_rate, pin_c_x_rate, pin_c_y_rate, pin_d_x_rate, pin_d_y_rate,
        slide_angle_rate, slide_across_rate, pin_e_x_rate, pin_e_y_rate, axle_a_x_rate,
        axle_a_y_rate]
}

/// `G = dg'/dq'`, values in the order of its pattern. 30 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 37] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * sin_post_phi;
    let t1 = R::literal(0.06) * sin_plate_phi;
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let t2 = R::literal(-0.1) * cos_post_phi;
    let t3 = R::literal(-0.06) * cos_plate_phi;
    [R::literal(1.0), t0, R::literal(1.0), t2, R::literal(-1.0), t0, R::literal(1.0), t1,
        R::literal(-1.0), t2, R::literal(1.0), t3, R::literal(-1.0), t1, R::literal(1.0),
        R::literal(0.06) * sin_cylinder_phi, R::literal(-1.0), t3, R::literal(1.0),
        R::literal(-0.06) * cos_cylinder_phi, R::literal(-1.0), R::literal(1.0), sin_cylinder_phi,
        -cos_cylinder_phi, -slide, -sin_cylinder_phi, cos_cylinder_phi, R::literal(1.0),
        R::literal(-0.06) * sin_rod_phi, R::literal(1.0), R::literal(0.06) * cos_rod_phi,
        R::literal(-1.0), R::literal(-0.01) * sin_plate_phi.add_product(R::literal(10.0),
        cos_plate_phi), R::literal(1.0), R::literal(-1.0), (R::literal(0.01)
        * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi), R::literal(1.0)]
}
