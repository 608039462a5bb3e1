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
// Operations: initial_state 1, rate 722, forcing 78, rate_jacobian 4759, parameter_jacobian 1065,
//     outputs 50, energy 78, power_balance 819, guards 27, guard_rates 709, constraint_values 49,
//     constraint_rates 63, constraint_matrix 30, prepare 1, prepared_rate 722,
//     prepared_rate_jacobian 4758.

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

/// As `rate`, with the constants of the parameters from `prepare`. 722 operations.
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
    let t11 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t12 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t13 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t14 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = t11 * R::literal(400.0);
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
    let t71 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t72 = t71 * t68;
    let t73 = (-t19).add_product(t23, t5);
    let t74 = t73 * t68;
    let t75 = (t51 - R::literal(0.833_333_333_333_333_4)).sub_product(t53, t48).add_product(t64,
        t58);
    let t76 = t75 * t68;
    let t77 = (-t54).add_product(t55, t48).sub_product(t67, t58);
    let t78 = t77 * t68;
    let t79 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t56
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t50, t45)
        .add_product(t61, t60)).add_product(t70, t69);
    let t80 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t72, t69);
    let t81 = t80 * t79;
    let t82 = t20.sub_product(t23, t4).add_product(t74, t69);
    let t83 = t82 * t79;
    let t84 = (-t62.add_product(t53, t45)).add_product(t64, t60).add_product(t76, t69);
    let t85 = t84 * t79;
    let t86 = (t65 - R::literal(0.833_333_333_333_333_4)).add_product(t55, t45).sub_product(t67,
        t60).add_product(t78, t69);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t72, t71)
        .sub_product(t81, t80);
    let t89 = t23.add_product(t74, t71).add_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t26 * t88;
    let t92 = t27 * t88;
    let t93 = (t76 * t71).add_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t71).add_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t74, t73).sub_product(t83, t82).sub_product(t90, t89);
    let t98 = t24.add_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = t25.add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (t76 * t73).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (t78 * t73).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t91, t26)
        .add_product(t99, t98);
    let t107 = (t27 * t6).add_product(t92, t26).add_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (t94 * t26).sub_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (t96 * t26).sub_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t92, t27).add_product(t101, t100)).add_product(t108, t107);
    let t114 = (-(t94 * t27)).add_product(t103, t100).add_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (-(t96 * t27)).add_product(t105, t100).add_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t11)
        + R::literal(1.428_571_428_571_428_6)).add_product(t53, t52).add_product(t64, t63))
        .add_product(t76, t75).sub_product(t85, t84).sub_product(t94, t93).sub_product(t103, t102)
        .add_product(t110, t109).sub_product(t115, t114);
    let t119 = (t18 * t11).add_product(t55, t52).add_product(t67, t63).add_product(t78, t75)
        .sub_product(t87, t84).sub_product(t96, t93).sub_product(t105, t102).add_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (R::literal(-1_000_000.0) * stop_gap * t7).sub_product(R::literal(1500.0) * stop_rate, t7));
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
    let t134 = t13 * t121;
    let t135 = t130 + t134;
    let t136 = t14 * t121;
    let t137 = t32 * t135;
    let t138 = R::literal(9.81) - t131 + t136 - t137;
    let t139 = (t130.add_product(t132, cos_plate_phi) + t134).add_product(t34, t135)
        .add_product(t40, t138);
    let t140 = (t136 - (t131.add_product(t132, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) - t137).sub_product(t42, t138).add_product(t47, t139);
    let t141 = R::literal(3.333_333_333_333_333_5) * t123;
    let t142 = (-t141.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))).add_product(t21, t127)
        .add_product(t49, t139).sub_product(t59, t140);
    let t143 = R::literal(3.333_333_333_333_333_5) * t126;
    let t144 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t143)
        .add_product(t22, t127)).add_product(t50, t139).sub_product(t61, t140).add_product(t70,
        t142);
    let t145 = (R::literal(-2_777.777_777_777_778) * t127).sub_product(t72, t142).sub_product(t81,
        t144);
    let t146 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t123)
        .add_product(t20, t126).sub_product(t23, t127).sub_product(t24, t123).add_product(t25, t128)
        .add_product(t74, t142).sub_product(t83, t144);
    let t147 = t146.add_product(t90, t145);
    let t148 = R::literal(5.0) * t123;
    let t149 = t148.add_product(t133, cos_rod_phi).sub_product(t91, t145).sub_product(t99, t147);
    let t150 = R::literal(5.0) * t128;
    let t151 = t150.add_product(t133, sin_rod_phi).add_product(t92, t145).add_product(t101, t147)
        .add_product(t108, t149);
    let t152 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_stiffness_times_contact_gap * t8 / between
        + contact_damping_times_contact_rate * t8 / between));
    let t153 = (-t152).add_product(t12, plate_omega_squared).add_product(t53, t139)
        .add_product(t64, t140).add_product(t76, t142).sub_product(t85, t144).add_product(t94, t145)
        .sub_product(t103, t147).add_product(t110, t149).sub_product(t115, t151);
    let t154 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_damping_times_contact_rate * t9 / between))
        - (R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t9 / between)));
    let t155 = (R::literal(-9.81).add_product(t11, plate_omega_squared) - t154).sub_product(t55,
        t139).sub_product(t67, t140).add_product(t78, t142).sub_product(t87, t144).add_product(t96,
        t145).sub_product(t105, t147).add_product(t112, t149).sub_product(t117, t151)
        .sub_product(t120, t153) * (R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4)
        .add_product(t18, t12) + R::literal(1.428_571_428_571_428_6)).add_product(t55, t54)
        .add_product(t67, t66)).add_product(t78, t77).sub_product(t87, t86).sub_product(t96, t95)
        .sub_product(t105, t104).add_product(t112, t111).sub_product(t117, t116).sub_product(t120,
        t119));
    let t156 = (t153 * t118).sub_product(t120, t155);
    let t157 = (t151 * t113).sub_product(t115, t156).sub_product(t117, t155);
    let t158 = (-(t149 * t106)).add_product(t108, t157).add_product(t110, t156).add_product(t112,
        t155);
    let t159 = (t147 * t97).sub_product(t99, t158).add_product(t101, t157).sub_product(t103, t156)
        .sub_product(t105, t155);
    let t160 = (t145 * t88).add_product(t90, t159).sub_product(t91, t158).add_product(t92, t157)
        .add_product(t94, t156).add_product(t96, t155);
    let t161 = (t144 * t79).sub_product(t81, t160).sub_product(t83, t159).sub_product(t85, t156)
        .sub_product(t87, t155);
    let t162 = (-(t142 * t68)).add_product(t70, t161).sub_product(t72, t160).add_product(t74, t159)
        .add_product(t76, t156).add_product(t78, t155);
    let t163 = (t140 * t57).sub_product(t59, t162).sub_product(t61, t161).add_product(t64, t156)
        .sub_product(t67, t155);
    let t164 = (-(t139 * t44).add_product(t47, t163).add_product(t49, t162).add_product(t50, t161)
        .add_product(t53, t156)).add_product(t55, t155);
    let t165 = (t138 * t38).sub_product(t40, t164).sub_product(t42, t163);
    let t166 = (t135 * t30).add_product(t32, t165).add_product(t34, t164).add_product(t32, t163);
    let bobbin_v_y_dot = t154.sub_product(R::literal(1.428_571_428_571_428_6), t155);
    let bobbin_v_x_dot = t152.sub_product(R::literal(1.428_571_428_571_428_6), t156);
    let rod_omega_dot = (t26 * t158).sub_product(R::literal(4_166.666_666_666_667), t160)
        .sub_product(t27, t157);
    let rod_v_y_dot = (-t150.add_product(t25, t159)).add_product(R::literal(-5.0), t157);
    let rod_v_x_dot = (-t148).add_product(t24, t159).sub_product(R::literal(5.0), t158);
    let cylinder_omega_dot = (-(t127 * R::literal(2_777.777_777_777_778)).add_product(t21, t162))
        .add_product(t22, t161).sub_product(R::literal(-2_777.777_777_777_778), t160)
        .add_product(t23, t159);
    let cylinder_v_y_dot = t143.sub_product(R::literal(3.333_333_333_333_333_5), t161)
        .add_product(t20, t159);
    let cylinder_v_x_dot = t141.sub_product(R::literal(3.333_333_333_333_333_5), t162)
        .sub_product(t19, t159);
    let plate_omega_dot = (t16 * t163).sub_product(t15, t164).sub_product(t15, t162)
        .add_product(t16, t161).add_product(t17, t156).sub_product(t18, t155);
    let plate_v_y_dot = R::literal(-9.81).sub_product(R::literal(0.833_333_333_333_333_4), t163)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t161)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t155);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t162)
        .add_product(R::literal(-0.833_333_333_333_333_4), t164)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t156);
    let post_omega_dot = (t121 * R::literal(370.370_370_370_370_3)).sub_product(t13, t166)
        .add_product(t14, t165).sub_product(t13, t164).add_product(t14, t163);
    let post_v_y_dot = R::literal(-9.81).sub_product(R::literal(1.25), t165)
        .sub_product(R::literal(-1.25), t163);
    let post_v_x_dot = (R::literal(1.25) * t164).add_product(R::literal(-1.25), t166);
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

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 78 operations.
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
        (R::literal(-1_000_000.0) * stop_gap * t0).sub_product(R::literal(1500.0) * stop_rate, t0));
    let t4 = p.spring_stiffness * (slide - R::literal(0.116));
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let cylinder_x_forcing = (t4 * cos_cylinder_phi).add_product(spring_damping_times_slide_rate,
        cos_cylinder_phi);
    let t5 = t4 * sin_cylinder_phi;
    let t6 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let cylinder_y_forcing = t6 - (R::literal(2.943) - t5);
    let cylinder_phi_forcing = -(t4 * t3).add_product(spring_damping_times_slide_rate, t3);
    let rod_x_forcing = -cylinder_x_forcing;
    let rod_y_forcing = R::literal(-1.962) - t5 - t6;
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

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 4758 operations.
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
    let t8 = R::literal(0.01) * cos_plate_phi;
    let t9 = R::literal(0.1) * sin_plate_phi;
    let t10 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t10;
    let t11 = bobbin_x - R::literal(0.328);
    let t12 = t11 * t11;
    let t13 = bobbin_y - R::literal(0.058);
    let t14 = t13 * t13;
    let between = (t12 + t14).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t11).add_product(bobbin_v_y, t13) / between;
    let t15 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t16 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t17 = t16 - t15;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi).add_product(cylinder_omega,
        t17).add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t18 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t19 = t9 - t8;
    let t20 = t8 - t9;
    let t21 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t22 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t23 = R::literal(24.0) * sin_plate_phi;
    let t24 = R::literal(24.0) * cos_plate_phi;
    let t25 = t18 * R::literal(400.0);
    let t26 = t20 * R::literal(400.0);
    let t27 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t28 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t29 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t30 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t31 = slide * R::literal(2_777.777_777_777_778);
    let t32 = sin_cylinder_phi * R::literal(5.0);
    let t33 = cos_cylinder_phi * R::literal(5.0);
    let t34 = R::literal(250.0) * sin_rod_phi;
    let t35 = R::literal(250.0) * cos_rod_phi;
    let t36 = t21 * t1;
    let t37 = R::literal(1.25) + t36;
    let t38 = R::literal(1.0) / t37;
    let t39 = t22 * t1;
    let t40 = t39 * t38;
    let t41 = R::literal(1.25) - t36;
    let t42 = t41 * t38;
    let t43 = t22 * t0;
    let t44 = R::literal(1.25) + t43;
    let t45 = t40 * t39;
    let t46 = R::literal(1.0) / (t45 - t44);
    let t47 = (t21 * t0).add_product(t42, t39);
    let t48 = t47 * t46;
    let t49 = R::literal(1.25) - t43 + t45;
    let t50 = t49 * t46;
    let t51 = t23 * t3;
    let t52 = R::literal(1.0) / (-(t37 + R::literal(0.833_333_333_333_333_4) + t51))
        .add_product(t42, t41).sub_product(t48, t47);
    let t53 = t24 * t3;
    let t54 = (t39 + t53).add_product(t40, t41).sub_product(t50, t47);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t25 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t26 * t3;
    let t63 = t62 * t52;
    let t64 = t24 * t2;
    let t65 = R::literal(1.0) / (t45 - (t44 + R::literal(0.833_333_333_333_333_4) + t64))
        .sub_product(t50, t49).sub_product(t55, t54);
    let t66 = (t23 * t2).sub_product(t57, t54);
    let t67 = t66 * t65;
    let t68 = (R::literal(0.833_333_333_333_333_4) - t64).sub_product(t58, t54);
    let t69 = t68 * t65;
    let t70 = t25 * t2;
    let t71 = t70.add_product(t61, t54);
    let t72 = t71 * t65;
    let t73 = t26 * t2;
    let t74 = (R::literal(0.833_333_333_333_333_4) + t73).add_product(t63, t54);
    let t75 = t74 * t65;
    let t76 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t51
        + R::literal(3.333_333_333_333_333_5)).add_product(t29, t5).add_product(t57, t56)
        .add_product(t67, t66);
    let t77 = t53.add_product(t30, t5).sub_product(t58, t56).sub_product(t69, t66);
    let t78 = t77 * t76;
    let t79 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t80 = t79 * t76;
    let t81 = (-t27).add_product(t31, t5);
    let t82 = t81 * t76;
    let t83 = (t59 - R::literal(0.833_333_333_333_333_4)).sub_product(t61, t56).add_product(t72,
        t66);
    let t84 = t83 * t76;
    let t85 = (-t62).add_product(t63, t56).sub_product(t75, t66);
    let t86 = t85 * t76;
    let t87 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t64
        + R::literal(3.333_333_333_333_333_5)).add_product(t30, t4).add_product(t58, t53)
        .add_product(t69, t68)).add_product(t78, t77);
    let t88 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t80, t77);
    let t89 = t88 * t87;
    let t90 = t28.sub_product(t31, t4).add_product(t82, t77);
    let t91 = t90 * t87;
    let t92 = (-t70.add_product(t61, t53)).add_product(t72, t68).add_product(t84, t77);
    let t93 = t92 * t87;
    let t94 = (t73 - R::literal(0.833_333_333_333_333_4)).add_product(t63, t53).sub_product(t75,
        t68).add_product(t86, t77);
    let t95 = t94 * t87;
    let t96 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t80, t79)
        .sub_product(t89, t88);
    let t97 = t31.add_product(t82, t79).add_product(t91, t88);
    let t98 = t97 * t96;
    let t99 = t34 * t96;
    let t100 = t35 * t96;
    let t101 = (t84 * t79).add_product(t93, t88);
    let t102 = t101 * t96;
    let t103 = (t86 * t79).add_product(t95, t88);
    let t104 = t103 * t96;
    let t105 = R::literal(1.0) / (-(t27 * sin_cylinder_phi).add_product(t28, cos_cylinder_phi)
        .add_product(t31, slide).add_product(t32, sin_cylinder_phi).add_product(t33,
        cos_cylinder_phi)).add_product(t82, t81).sub_product(t91, t90).sub_product(t98, t97);
    let t106 = t32.add_product(t99, t97);
    let t107 = t106 * t105;
    let t108 = t33.add_product(t100, t97);
    let t109 = t108 * t105;
    let t110 = (t84 * t81).sub_product(t93, t90).sub_product(t102, t97);
    let t111 = t110 * t105;
    let t112 = (t86 * t81).sub_product(t95, t90).sub_product(t104, t97);
    let t113 = t112 * t105;
    let t114 = R::literal(1.0) / R::literal(5.0).add_product(t34, t7).add_product(t99, t34)
        .add_product(t107, t106);
    let t115 = (t35 * t7).add_product(t100, t34).add_product(t109, t106);
    let t116 = t115 * t114;
    let t117 = (t102 * t34).sub_product(t111, t106);
    let t118 = t117 * t114;
    let t119 = (t104 * t34).sub_product(t113, t106);
    let t120 = t119 * t114;
    let t121 = R::literal(1.0) / (-R::literal(5.0).add_product(t35, t6).add_product(t100, t35)
        .add_product(t109, t108)).add_product(t116, t115);
    let t122 = (-(t102 * t35)).add_product(t111, t108).add_product(t118, t115);
    let t123 = t122 * t121;
    let t124 = (-(t104 * t35)).add_product(t113, t108).add_product(t120, t115);
    let t125 = t124 * t121;
    let t126 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t25, t18)
        + R::literal(1.428_571_428_571_428_6)).add_product(t61, t60).add_product(t72, t71))
        .add_product(t84, t83).sub_product(t93, t92).sub_product(t102, t101).sub_product(t111, t110)
        .add_product(t118, t117).sub_product(t123, t122);
    let t127 = (t26 * t18).add_product(t63, t60).add_product(t75, t71).add_product(t86, t83)
        .sub_product(t95, t92).sub_product(t104, t101).sub_product(t113, t110).add_product(t120,
        t117).sub_product(t125, t122);
    let t128 = t127 * t126;
    let t129 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t26, t20)
        + R::literal(1.428_571_428_571_428_6)).add_product(t63, t62).add_product(t75, t74))
        .add_product(t86, t85).sub_product(t95, t94).sub_product(t104, t103).sub_product(t113, t112)
        .add_product(t120, t119).sub_product(t125, t124).sub_product(t128, t127);
    let t130 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (R::literal(-1_000_000.0) * stop_gap * t10).sub_product(R::literal(1500.0) * stop_rate,
        t10));
    let t131 = slide - R::literal(0.116);
    let t132 = p.spring_stiffness * t131;
    let t133 = t132 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t134 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t135 = t133 + t134;
    let t136 = t132 * sin_cylinder_phi;
    let t137 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t138 = t137 - (R::literal(2.943) - t136);
    let t139 = (t132 * t17).add_product(spring_damping_times_slide_rate, t17);
    let t140 = t137 + (R::literal(1.962) + t136);
    let t141 = contact_stiffness_times_contact_gap * t11;
    let t142 = R::literal(0.1) * (post_omega * post_omega);
    let t143 = t142 * cos_post_phi;
    let t144 = t142 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t145 = R::literal(0.06) * plate_omega_squared;
    let t146 = t145 * cos_plate_phi;
    let t147 = t145 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t148 = cylinder_omega_squared * cos_cylinder_phi;
    let t149 = cylinder_omega_squared * sin_cylinder_phi;
    let t150 = R::literal(2.0) * cylinder_v_x;
    let t151 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t152 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t153 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t154 = R::literal(2.0) * rod_v_x;
    let t155 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t156 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t157 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t158 = R::literal(0.06) * (rod_omega * rod_omega);
    let t159 = t158 * cos_rod_phi;
    let t160 = t158 * sin_rod_phi;
    let t161 = t20 * plate_omega_squared;
    let t162 = t18 * plate_omega_squared;
    let t163 = t21 * t130;
    let t164 = t143 + t163;
    let t165 = t22 * t130;
    let t166 = t40 * t164;
    let t167 = R::literal(9.81) - t144 + t165 - t166;
    let t168 = (t146 + t143 + t163).add_product(t42, t164).add_product(t48, t167);
    let t169 = (t165 - (t147 + t144 + R::literal(9.81)) + R::literal(9.81) - t166).sub_product(t50,
        t167).add_product(t55, t168);
    let t170 = R::literal(3.333_333_333_333_333_5) * t135;
    let t171 = (-t170.add_product(R::literal(0.06), t148.add_product(plate_omega_squared,
        cos_plate_phi))).add_product(t29, t139).add_product(t57, t168).sub_product(t67, t169);
    let t172 = R::literal(3.333_333_333_333_333_5) * t138;
    let t173 = (-(R::literal(9.81).add_product(R::literal(0.06), t149
        .add_product(plate_omega_squared, sin_plate_phi)) + t172).add_product(t30, t139))
        .add_product(t58, t168).sub_product(t69, t169).add_product(t78, t171);
    let t174 = (R::literal(-2_777.777_777_777_778) * t139).sub_product(t80, t171).sub_product(t89,
        t173);
    let t175 = (cylinder_omega * (((t154 * cos_cylinder_phi).add_product(t155, sin_cylinder_phi)
        + t156 + t157).sub_product(t150, cos_cylinder_phi).sub_product(t151, sin_cylinder_phi)
        - t152 - t153)).sub_product(t27, t135).add_product(t28, t138).sub_product(t31, t139)
        .sub_product(t32, t135).add_product(t33, t140).add_product(t82, t171).sub_product(t91, t173)
        .add_product(t98, t174);
    let t176 = R::literal(5.0) * t135;
    let t177 = (t159 + t176).sub_product(t99, t174).sub_product(t107, t175);
    let t178 = R::literal(5.0) * t140;
    let t179 = (t160 + t178).add_product(t100, t174).add_product(t109, t175).add_product(t116,
        t177);
    let t180 = t161.sub_product(R::literal(1.428_571_428_571_428_6), R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t141 / between + contact_damping_times_contact_rate
        * t11 / between))).add_product(t61, t168).add_product(t72, t169).add_product(t84, t171)
        .sub_product(t93, t173).add_product(t102, t174).sub_product(t111, t175).add_product(t118,
        t177).sub_product(t123, t179);
    let t181 = (t162 - R::literal(9.81)).sub_product(R::literal(1.428_571_428_571_428_6),
        R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(contact_damping_times_contact_rate * t13 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t13 / between))).sub_product(t63, t168)
        .sub_product(t75, t169).add_product(t86, t171).sub_product(t95, t173).add_product(t104,
        t174).sub_product(t113, t175).add_product(t120, t177).sub_product(t125, t179)
        .sub_product(t128, t180) * t129;
    let t182 = (t180 * t126).sub_product(t128, t181);
    let t183 = (t179 * t121).sub_product(t123, t182).sub_product(t125, t181);
    let t184 = (-(t177 * t114)).add_product(t116, t183).add_product(t118, t182).add_product(t120,
        t181);
    let t185 = (t175 * t105).sub_product(t107, t184).add_product(t109, t183).sub_product(t111, t182)
        .sub_product(t113, t181);
    let t186 = (t174 * t96).add_product(t98, t185).sub_product(t99, t184).add_product(t100, t183)
        .add_product(t102, t182).add_product(t104, t181);
    let t187 = (t173 * t87).sub_product(t89, t186).sub_product(t91, t185).sub_product(t93, t182)
        .sub_product(t95, t181);
    let t188 = (-(t171 * t76)).add_product(t78, t187).sub_product(t80, t186).add_product(t82, t185)
        .add_product(t84, t182).add_product(t86, t181);
    let t189 = (t169 * t65).sub_product(t67, t188).sub_product(t69, t187).add_product(t72, t182)
        .sub_product(t75, t181);
    let t190 = (-(t168 * t52).add_product(t55, t189).add_product(t57, t188).add_product(t58, t187)
        .add_product(t61, t182)).add_product(t63, t181);
    let t191 = (t167 * t46).sub_product(t48, t190).sub_product(t50, t189);
    let t192 = (t164 * t38).add_product(t40, t191).add_product(t42, t190).add_product(t40, t189);
    let rod_omega_dot = (t34 * t184).sub_product(R::literal(4_166.666_666_666_667), t186)
        .sub_product(t35, t183);
    let rod_v_x_dot = (-t176).add_product(t32, t185).sub_product(R::literal(5.0), t184);
    let cylinder_omega_dot = (-(t139 * R::literal(2_777.777_777_777_778)).add_product(t29, t188))
        .add_product(t30, t187).sub_product(R::literal(-2_777.777_777_777_778), t186)
        .add_product(t31, t185);
    let cylinder_v_y_dot = t172.sub_product(R::literal(3.333_333_333_333_333_5), t187)
        .add_product(t28, t185);
    let cylinder_v_x_dot = t170.sub_product(R::literal(3.333_333_333_333_333_5), t188)
        .sub_product(t27, t185);
    let plate_omega_dot = (t24 * t189).sub_product(t23, t190).sub_product(t23, t188)
        .add_product(t24, t187).add_product(t25, t182).sub_product(t26, t181);
    let post_omega_dot = (t130 * R::literal(370.370_370_370_370_3)).sub_product(t21, t192)
        .add_product(t22, t191).sub_product(t21, t190).add_product(t22, t189);
    let t193 = t10 * t10;
    let t194 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), (R::literal(3000.0)
        * stop_gap * stop_rate).add_product(R::literal(1_000_000.0), stop_gap * stop_gap)
        .sub_product(R::literal(1_000_000.0), t193)).sub_product(t0, t192).sub_product(t1, t191)
        .sub_product(t0, t190).sub_product(t1, t189);
    let t195 = t144.sub_product(t0, post_omega_dot).sub_product(t21, t194);
    let t196 = (-t143.add_product(t1, post_omega_dot)).add_product(t22, t194).add_product(t40,
        t195);
    let t197 = t195.add_product(t42, t195).sub_product(t48, t196);
    let t198 = t196.sub_product(t50, t196).sub_product(t55, t197);
    let t199 = (t57 * t197).add_product(t67, t198);
    let t200 = (t58 * t197).add_product(t69, t198).add_product(t78, t199);
    let t201 = (t80 * t199).add_product(t89, t200);
    let t202 = (-(t82 * t199)).add_product(t91, t200).add_product(t98, t201);
    let t203 = (t99 * t201).add_product(t107, t202);
    let t204 = (t100 * t201).add_product(t109, t202).sub_product(t116, t203);
    let t205 = (-(t61 * t197)).add_product(t72, t198).sub_product(t84, t199).add_product(t93, t200)
        .add_product(t102, t201).sub_product(t111, t202).sub_product(t118, t203).sub_product(t123,
        t204);
    let t206 = (t63 * t197).sub_product(t75, t198).sub_product(t86, t199).add_product(t95, t200)
        .add_product(t104, t201).sub_product(t113, t202).sub_product(t120, t203).sub_product(t125,
        t204).sub_product(t128, t205) * t129;
    let t207 = (t205 * t126).sub_product(t128, t206);
    let t208 = (t204 * t121).sub_product(t123, t207).sub_product(t125, t206);
    let t209 = (t203 * t114).add_product(t116, t208).add_product(t118, t207).add_product(t120,
        t206);
    let t210 = (t202 * t105).sub_product(t107, t209).add_product(t109, t208).sub_product(t111, t207)
        .sub_product(t113, t206);
    let t211 = (t201 * t96).add_product(t98, t210).sub_product(t99, t209).add_product(t100, t208)
        .add_product(t102, t207).add_product(t104, t206);
    let t212 = (t200 * t87).add_product(t89, t211).add_product(t91, t210).add_product(t93, t207)
        .add_product(t95, t206);
    let t213 = (t199 * t76).sub_product(t78, t212).sub_product(t80, t211).add_product(t82, t210)
        .add_product(t84, t207).add_product(t86, t206);
    let t214 = (t198 * t65).sub_product(t67, t213).add_product(t69, t212).add_product(t72, t207)
        .sub_product(t75, t206);
    let t215 = (t197 * t52).sub_product(t55, t214).sub_product(t57, t213).add_product(t58, t212)
        .sub_product(t61, t207).add_product(t63, t206);
    let t216 = (t196 * t46).sub_product(t48, t215).sub_product(t50, t214);
    let t217 = (-(t195 * t38)).add_product(t40, t216).add_product(t42, t215).add_product(t40, t214);
    let bobbin_v_y_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t206;
    let bobbin_v_x_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t207;
    let rod_omega_dot_by_post_phi = (t34 * t209).sub_product(R::literal(4_166.666_666_666_667),
        t211).sub_product(t35, t208);
    let rod_v_y_dot_by_post_phi = (R::literal(-5.0) * t208).sub_product(t33, t210);
    let rod_v_x_dot_by_post_phi = (R::literal(-5.0) * t209).add_product(t32, t210);
    let cylinder_omega_dot_by_post_phi = (-(t30 * t212).add_product(t29, t213)
        .add_product(R::literal(-2_777.777_777_777_778), t211)).add_product(t31, t210);
    let cylinder_v_y_dot_by_post_phi = (t28 * t210)
        .add_product(R::literal(3.333_333_333_333_333_5), t212);
    let cylinder_v_x_dot_by_post_phi = (-(t27 * t210))
        .add_product(R::literal(-3.333_333_333_333_333_5), t213);
    let plate_omega_dot_by_post_phi = (t24 * t214).sub_product(t23, t215).sub_product(t23, t213)
        .sub_product(t24, t212).add_product(t25, t207).sub_product(t26, t206);
    let plate_v_y_dot_by_post_phi = (R::literal(-0.833_333_333_333_333_4) * t212)
        .sub_product(R::literal(0.833_333_333_333_333_4), t214)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t206);
    let plate_v_x_dot_by_post_phi = (R::literal(0.833_333_333_333_333_4) * t213)
        .add_product(R::literal(-0.833_333_333_333_333_4), t215)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t207);
    let post_omega_dot_by_post_phi = (t194 * R::literal(370.370_370_370_370_3)).sub_product(t21,
        t217).add_product(t22, t216).sub_product(t21, t215).add_product(t22, t214);
    let post_v_y_dot_by_post_phi = (R::literal(1.25) * t214).add_product(R::literal(-1.25), t216);
    let post_v_x_dot_by_post_phi = (R::literal(1.25) * t215).add_product(R::literal(-1.25), t217);
    let t218 = (-(t3 * t189).add_product(t2, t190).add_product(t2, t188).add_product(t3, t187)
        .add_product(t19, t182)).add_product(t18, t181);
    let t219 = t147.sub_product(t2, plate_omega_dot).sub_product(t23, t218);
    let t220 = (-t146.add_product(t3, plate_omega_dot)).add_product(t24, t218);
    let t221 = t220.sub_product(t55, t219);
    let t222 = t219.sub_product(t57, t219).sub_product(t67, t221);
    let t223 = t220.sub_product(t58, t219).sub_product(t69, t221).add_product(t78, t222);
    let t224 = (t80 * t222).add_product(t89, t223);
    let t225 = (t82 * t222).sub_product(t91, t223).sub_product(t98, t224);
    let t226 = (t99 * t224).sub_product(t107, t225);
    let t227 = (-(t100 * t224)).add_product(t109, t225).add_product(t116, t226);
    let t228 = (-t162.add_product(t19, plate_omega_dot)).add_product(t25, t218).sub_product(t61,
        t219).add_product(t72, t221).add_product(t84, t222).sub_product(t93, t223)
        .sub_product(t102, t224).sub_product(t111, t225).add_product(t118, t226).sub_product(t123,
        t227);
    let t229 = t161.add_product(t18, plate_omega_dot).sub_product(t26, t218).add_product(t63, t219)
        .sub_product(t75, t221).add_product(t86, t222).sub_product(t95, t223).sub_product(t104,
        t224).sub_product(t113, t225).add_product(t120, t226).sub_product(t125, t227)
        .sub_product(t128, t228) * t129;
    let t230 = (t228 * t126).sub_product(t128, t229);
    let t231 = (t227 * t121).sub_product(t123, t230).sub_product(t125, t229);
    let t232 = (-(t226 * t114)).add_product(t116, t231).add_product(t118, t230).add_product(t120,
        t229);
    let t233 = (t225 * t105).sub_product(t107, t232).add_product(t109, t231).sub_product(t111, t230)
        .sub_product(t113, t229);
    let t234 = (-(t224 * t96)).add_product(t98, t233).sub_product(t99, t232).add_product(t100, t231)
        .add_product(t102, t230).add_product(t104, t229);
    let t235 = (t223 * t87).sub_product(t89, t234).sub_product(t91, t233).sub_product(t93, t230)
        .sub_product(t95, t229);
    let t236 = (-(t222 * t76)).add_product(t78, t235).sub_product(t80, t234).add_product(t82, t233)
        .add_product(t84, t230).add_product(t86, t229);
    let t237 = (t221 * t65).sub_product(t67, t236).sub_product(t69, t235).add_product(t72, t230)
        .sub_product(t75, t229);
    let t238 = (t219 * t52).sub_product(t55, t237).sub_product(t57, t236).sub_product(t58, t235)
        .sub_product(t61, t230).add_product(t63, t229);
    let t239 = (t50 * t237).add_product(t48, t238);
    let t240 = (t42 * t238).sub_product(t40, t239).add_product(t40, t237);
    let bobbin_v_y_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t229;
    let bobbin_v_x_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t230;
    let rod_omega_dot_by_plate_phi = (t34 * t232).sub_product(R::literal(4_166.666_666_666_667),
        t234).sub_product(t35, t231);
    let rod_v_y_dot_by_plate_phi = (R::literal(-5.0) * t231).sub_product(t33, t233);
    let rod_v_x_dot_by_plate_phi = (R::literal(-5.0) * t232).add_product(t32, t233);
    let cylinder_omega_dot_by_plate_phi = (t30 * t235).sub_product(t29, t236)
        .sub_product(R::literal(-2_777.777_777_777_778), t234).add_product(t31, t233);
    let cylinder_v_y_dot_by_plate_phi = (t28 * t233)
        .sub_product(R::literal(3.333_333_333_333_333_5), t235);
    let cylinder_v_x_dot_by_plate_phi = (-(t27 * t233))
        .add_product(R::literal(-3.333_333_333_333_333_5), t236);
    let plate_omega_dot_by_plate_phi = (t218 * R::literal(400.0)).sub_product(t23, t238)
        .add_product(t24, t237).sub_product(t23, t236).add_product(t24, t235).add_product(t25, t230)
        .sub_product(t26, t229);
    let plate_v_y_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t235)
        .add_product(R::literal(-0.833_333_333_333_333_4), t237)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t229);
    let plate_v_x_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t236)
        .add_product(R::literal(-0.833_333_333_333_333_4), t238)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t230);
    let post_omega_dot_by_plate_phi = (-(t22 * t239).add_product(t21, t240).add_product(t21, t238))
        .add_product(t22, t237);
    let post_v_y_dot_by_plate_phi = (R::literal(1.25) * t237).add_product(R::literal(1.25), t239);
    let post_v_x_dot_by_plate_phi = (R::literal(1.25) * t238).add_product(R::literal(-1.25), t240);
    let t241 = p.spring_stiffness * cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t242 = spring_damping_times_cylinder_omega * sin_cylinder_phi;
    let t243 = t242 - t241;
    let t244 = t243 * cos_cylinder_phi;
    let t245 = t243 * sin_cylinder_phi;
    let t246 = spring_damping_times_cylinder_omega * t17;
    let t247 = t246 * sin_cylinder_phi;
    let t248 = p.spring_stiffness * t17;
    let t249 = t248 * cos_cylinder_phi;
    let t250 = t241 - t242;
    let t251 = t250 * cos_cylinder_phi;
    let t252 = t250 * sin_cylinder_phi;
    let t253 = cos_cylinder_phi * t185;
    let t254 = t249 - t247 - t136 - t137 - t253;
    let t255 = cos_cylinder_phi * cylinder_omega_dot;
    let t256 = R::literal(3.333_333_333_333_333_5) * t244;
    let t257 = t256.add_product(t29, t254);
    let t258 = R::literal(3.333_333_333_333_333_5) * t245;
    let t259 = (-t258).add_product(t30, t254).sub_product(t78, t257);
    let t260 = (R::literal(2_777.777_777_777_778) * t254).add_product(t80, t257).sub_product(t89,
        t259);
    let t261 = (t149 - t255).sub_product(t27, t244).add_product(t28, t245).add_product(t31, t254)
        .add_product(t32, t251).sub_product(t33, t252).sub_product(t82, t257).sub_product(t91, t259)
        .add_product(t98, t260);
    let t262 = R::literal(5.0) * t251;
    let t263 = t262.add_product(t99, t260).add_product(t107, t261);
    let t264 = R::literal(5.0) * t252;
    let t265 = (-t264).add_product(t100, t260).add_product(t109, t261).sub_product(t116, t263);
    let t266 = (-(t84 * t257).add_product(t93, t259)).add_product(t102, t260).sub_product(t111,
        t261).sub_product(t118, t263).sub_product(t123, t265);
    let t267 = (-(t86 * t257).add_product(t95, t259)).add_product(t104, t260).sub_product(t113,
        t261).sub_product(t120, t263).sub_product(t125, t265).sub_product(t128, t266) * t129;
    let t268 = (t266 * t126).sub_product(t128, t267);
    let t269 = (t265 * t121).sub_product(t123, t268).sub_product(t125, t267);
    let t270 = (t263 * t114).add_product(t116, t269).add_product(t118, t268).add_product(t120,
        t267);
    let t271 = (t261 * t105).sub_product(t107, t270).add_product(t109, t269).sub_product(t111, t268)
        .sub_product(t113, t267);
    let t272 = (t260 * t96).add_product(t98, t271).sub_product(t99, t270).add_product(t100, t269)
        .add_product(t102, t268).add_product(t104, t267);
    let t273 = (t259 * t87).sub_product(t89, t272).sub_product(t91, t271).sub_product(t93, t268)
        .sub_product(t95, t267);
    let t274 = (t257 * t76).add_product(t78, t273).sub_product(t80, t272).add_product(t82, t271)
        .add_product(t84, t268).add_product(t86, t267);
    let t275 = (-(t69 * t273).add_product(t67, t274)).add_product(t72, t268).sub_product(t75, t267);
    let t276 = (-(t57 * t274).add_product(t55, t275).add_product(t58, t273).add_product(t61, t268))
        .add_product(t63, t267);
    let t277 = (t50 * t275).add_product(t48, t276);
    let t278 = (t42 * t276).sub_product(t40, t277).add_product(t40, t275);
    let bobbin_v_y_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t267;
    let bobbin_v_x_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t268;
    let rod_omega_dot_by_cylinder_x = (t34 * t270).sub_product(R::literal(4_166.666_666_666_667),
        t272).sub_product(t35, t269);
    let rod_v_y_dot_by_cylinder_x = t264.sub_product(t33, t271).sub_product(R::literal(5.0), t269);
    let rod_v_x_dot_by_cylinder_x = t262.add_product(t32, t271).sub_product(R::literal(5.0), t270);
    let cylinder_omega_dot_by_cylinder_x = (t254 * R::literal(2_777.777_777_777_778))
        .sub_product(t29, t274).add_product(t30, t273)
        .sub_product(R::literal(-2_777.777_777_777_778), t272).add_product(t31, t271);
    let cylinder_v_y_dot_by_cylinder_x = t258.sub_product(R::literal(3.333_333_333_333_333_5), t273)
        .add_product(t28, t271);
    let cylinder_v_x_dot_by_cylinder_x = t256.sub_product(R::literal(3.333_333_333_333_333_5), t274)
        .sub_product(t27, t271);
    let plate_omega_dot_by_cylinder_x = (t24 * t275).sub_product(t23, t276).sub_product(t23, t274)
        .add_product(t24, t273).add_product(t25, t268).sub_product(t26, t267);
    let plate_v_y_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t273)
        .add_product(R::literal(-0.833_333_333_333_333_4), t275)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t267);
    let plate_v_x_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t274)
        .add_product(R::literal(-0.833_333_333_333_333_4), t276)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t268);
    let post_omega_dot_by_cylinder_x = (-(t22 * t277).add_product(t21, t278).add_product(t21, t276))
        .add_product(t22, t275);
    let post_v_y_dot_by_cylinder_x = (R::literal(1.25) * t275).add_product(R::literal(1.25), t277);
    let post_v_x_dot_by_cylinder_x = (R::literal(1.25) * t276).add_product(R::literal(-1.25), t278);
    let t279 = (spring_damping_times_cylinder_omega * cos_cylinder_phi)
        .add_product(p.spring_stiffness, sin_cylinder_phi);
    let t280 = t279 * cos_cylinder_phi;
    let t281 = t279 * sin_cylinder_phi;
    let t282 = t248 * sin_cylinder_phi;
    let t283 = t133.add_product(t246, cos_cylinder_phi) + t282 + t134;
    let t284 = sin_cylinder_phi * t185;
    let t285 = t283 - t284;
    let t286 = t148.add_product(sin_cylinder_phi, cylinder_omega_dot);
    let t287 = R::literal(3.333_333_333_333_333_5) * t280;
    let t288 = t287.sub_product(t29, t285);
    let t289 = R::literal(3.333_333_333_333_333_5) * t281;
    let t290 = t289.add_product(t30, t285).add_product(t78, t288);
    let t291 = (R::literal(-2_777.777_777_777_778) * t285).add_product(t80, t288).add_product(t89,
        t290);
    let t292 = t27 * t280;
    let t293 = t28 * t281;
    let t294 = t32 * t280;
    let t295 = t33 * t281;
    let t296 = ((t292 - t286 - t293).add_product(t31, t285) + t294 - t295).add_product(t82, t288)
        .sub_product(t91, t290).sub_product(t98, t291);
    let t297 = R::literal(5.0) * t280;
    let t298 = (-t297).add_product(t99, t291).sub_product(t107, t296);
    let t299 = R::literal(5.0) * t281;
    let t300 = (-t299.add_product(t100, t291)).add_product(t109, t296).add_product(t116, t298);
    let t301 = (t84 * t288).sub_product(t93, t290).sub_product(t102, t291).sub_product(t111, t296)
        .add_product(t118, t298).sub_product(t123, t300);
    let t302 = (t86 * t288).sub_product(t95, t290).sub_product(t104, t291).sub_product(t113, t296)
        .add_product(t120, t298).sub_product(t125, t300).sub_product(t128, t301) * t129;
    let t303 = (t301 * t126).sub_product(t128, t302);
    let t304 = (t300 * t121).sub_product(t123, t303).sub_product(t125, t302);
    let t305 = (-(t298 * t114)).add_product(t116, t304).add_product(t118, t303).add_product(t120,
        t302);
    let t306 = (t296 * t105).sub_product(t107, t305).add_product(t109, t304).sub_product(t111, t303)
        .sub_product(t113, t302);
    let t307 = (-(t291 * t96)).add_product(t98, t306).sub_product(t99, t305).add_product(t100, t304)
        .add_product(t102, t303).add_product(t104, t302);
    let t308 = (t290 * t87).sub_product(t89, t307).sub_product(t91, t306).sub_product(t93, t303)
        .sub_product(t95, t302);
    let t309 = (-(t288 * t76)).add_product(t78, t308).sub_product(t80, t307).add_product(t82, t306)
        .add_product(t84, t303).add_product(t86, t302);
    let t310 = (-(t69 * t308).add_product(t67, t309)).add_product(t72, t303).sub_product(t75, t302);
    let t311 = (-(t57 * t309).add_product(t55, t310).add_product(t58, t308).add_product(t61, t303))
        .add_product(t63, t302);
    let t312 = (t50 * t310).add_product(t48, t311);
    let t313 = (t42 * t311).sub_product(t40, t312).add_product(t40, t310);
    let bobbin_v_y_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t302;
    let bobbin_v_x_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t303;
    let rod_omega_dot_by_cylinder_y = (t34 * t305).sub_product(R::literal(4_166.666_666_666_667),
        t307).sub_product(t35, t304);
    let rod_v_y_dot_by_cylinder_y = t299.sub_product(t33, t306).sub_product(R::literal(5.0), t304);
    let rod_v_x_dot_by_cylinder_y = t297.add_product(t32, t306).sub_product(R::literal(5.0), t305);
    let cylinder_omega_dot_by_cylinder_y = (t285 * R::literal(2_777.777_777_777_778))
        .sub_product(t29, t309).add_product(t30, t308)
        .sub_product(R::literal(-2_777.777_777_777_778), t307).add_product(t31, t306);
    let cylinder_v_y_dot_by_cylinder_y = (-t289.add_product(R::literal(3.333_333_333_333_333_5),
        t308)).add_product(t28, t306);
    let cylinder_v_x_dot_by_cylinder_y = (-t287).add_product(R::literal(-3.333_333_333_333_333_5),
        t309).sub_product(t27, t306);
    let plate_omega_dot_by_cylinder_y = (t24 * t310).sub_product(t23, t311).sub_product(t23, t309)
        .add_product(t24, t308).add_product(t25, t303).sub_product(t26, t302);
    let plate_v_y_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t308)
        .add_product(R::literal(-0.833_333_333_333_333_4), t310)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t302);
    let plate_v_x_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t309)
        .add_product(R::literal(-0.833_333_333_333_333_4), t311)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t303);
    let post_omega_dot_by_cylinder_y = (-(t22 * t312).add_product(t21, t313).add_product(t21, t311))
        .add_product(t22, t310);
    let post_v_y_dot_by_cylinder_y = (R::literal(1.25) * t310).add_product(R::literal(1.25), t312);
    let post_v_x_dot_by_cylinder_y = (R::literal(1.25) * t311).add_product(R::literal(-1.25), t313);
    let t314 = p.spring_damping * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
        .sub_product(cylinder_omega, slide).sub_product(rod_v_x_minus_cylinder_v_x,
        sin_cylinder_phi);
    let t315 = t314 * cos_cylinder_phi;
    let t316 = t134.add_product(t314, sin_cylinder_phi) + (t133 + t282);
    let t317 = t17 * t17;
    let t318 = R::literal(0.06) * cylinder_omega_squared;
    let t319 = t249 + t315 - t136 - t137 - t253;
    let t320 = t316 - t284;
    let t321 = t15 - t16;
    let t322 = (p.spring_stiffness * slide * t131).add_product(p.spring_damping * slide, slide_rate)
        .sub_product(p.spring_stiffness, t317).sub_product(t314, t17).sub_product(t4, t188)
        .sub_product(t5, t187).sub_product(t321, t185);
    let t323 = t136 + t137 - t249 - t315 + t253;
    let t324 = t284 - t316;
    let t325 = R::literal(3.333_333_333_333_333_5) * t319;
    let t326 = ((t318 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t325)
        .sub_product(t29, t322);
    let t327 = R::literal(3.333_333_333_333_333_5) * t320;
    let t328 = (-((t318 * cos_cylinder_phi).add_product(t5, cylinder_omega_dot) + t327))
        .add_product(t30, t322).add_product(t78, t326);
    let t329 = (R::literal(-2_777.777_777_777_778) * t322).add_product(t80, t326).add_product(t89,
        t328);
    let t330 = (cylinder_omega * (t150 * sin_cylinder_phi).add_product(t155, cos_cylinder_phi)
        .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
        .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi).sub_product(t151,
        cos_cylinder_phi).sub_product(t154, sin_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi)).sub_product(cos_cylinder_phi,
        cylinder_v_x_dot).sub_product(sin_cylinder_phi, cylinder_v_y_dot).sub_product(t321,
        cylinder_omega_dot).add_product(cos_cylinder_phi, rod_v_x_dot)
        .sub_product(sin_cylinder_phi, t178.add_product(t33, t185).add_product(R::literal(5.0),
        t183)).sub_product(t27, t319).add_product(t28, t320).add_product(t31, t322)
        .add_product(t32, t323).sub_product(t33, t324).add_product(t82, t326).sub_product(t91, t328)
        .sub_product(t98, t329);
    let t331 = R::literal(5.0) * t323;
    let t332 = (-t331).add_product(t99, t329).sub_product(t107, t330);
    let t333 = R::literal(5.0) * t324;
    let t334 = (-t333.add_product(t100, t329)).add_product(t109, t330).add_product(t116, t332);
    let t335 = (t84 * t326).sub_product(t93, t328).sub_product(t102, t329).sub_product(t111, t330)
        .add_product(t118, t332).sub_product(t123, t334);
    let t336 = (t86 * t326).sub_product(t95, t328).sub_product(t104, t329).sub_product(t113, t330)
        .add_product(t120, t332).sub_product(t125, t334).sub_product(t128, t335) * t129;
    let t337 = (t335 * t126).sub_product(t128, t336);
    let t338 = (t334 * t121).sub_product(t123, t337).sub_product(t125, t336);
    let t339 = (-(t332 * t114)).add_product(t116, t338).add_product(t118, t337).add_product(t120,
        t336);
    let t340 = (t330 * t105).sub_product(t107, t339).add_product(t109, t338).sub_product(t111, t337)
        .sub_product(t113, t336);
    let t341 = (-(t329 * t96)).add_product(t98, t340).sub_product(t99, t339).add_product(t100, t338)
        .add_product(t102, t337).add_product(t104, t336);
    let t342 = (t328 * t87).sub_product(t89, t341).sub_product(t91, t340).sub_product(t93, t337)
        .sub_product(t95, t336);
    let t343 = (-(t326 * t76)).add_product(t78, t342).sub_product(t80, t341).add_product(t82, t340)
        .add_product(t84, t337).add_product(t86, t336);
    let t344 = (-(t69 * t342).add_product(t67, t343)).add_product(t72, t337).sub_product(t75, t336);
    let t345 = (-(t57 * t343).add_product(t55, t344).add_product(t58, t342).add_product(t61, t337))
        .add_product(t63, t336);
    let t346 = (t50 * t344).add_product(t48, t345);
    let t347 = (t42 * t345).sub_product(t40, t346).add_product(t40, t344);
    let bobbin_v_y_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t336;
    let bobbin_v_x_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t337;
    let rod_omega_dot_by_cylinder_phi = (t34 * t339).sub_product(R::literal(4_166.666_666_666_667),
        t341).sub_product(t35, t338);
    let rod_v_y_dot_by_cylinder_phi = t333.sub_product(t33, t340).sub_product(R::literal(5.0),
        t338);
    let rod_v_x_dot_by_cylinder_phi = t331.add_product(t32, t340).sub_product(R::literal(5.0),
        t339);
    let cylinder_omega_dot_by_cylinder_phi = (t322 * R::literal(2_777.777_777_777_778))
        .sub_product(t29, t343).add_product(t30, t342)
        .sub_product(R::literal(-2_777.777_777_777_778), t341).add_product(t31, t340);
    let cylinder_v_y_dot_by_cylinder_phi = t327.sub_product(R::literal(3.333_333_333_333_333_5),
        t342).add_product(t28, t340);
    let cylinder_v_x_dot_by_cylinder_phi = t325.sub_product(R::literal(3.333_333_333_333_333_5),
        t343).sub_product(t27, t340);
    let plate_omega_dot_by_cylinder_phi = (t24 * t344).sub_product(t23, t345).sub_product(t23, t343)
        .add_product(t24, t342).add_product(t25, t337).sub_product(t26, t336);
    let plate_v_y_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t342)
        .add_product(R::literal(-0.833_333_333_333_333_4), t344)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t336);
    let plate_v_x_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t343)
        .add_product(R::literal(-0.833_333_333_333_333_4), t345)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t337);
    let post_omega_dot_by_cylinder_phi = (-(t22 * t346).add_product(t21, t347).add_product(t21,
        t345)).add_product(t22, t344);
    let post_v_y_dot_by_cylinder_phi = (R::literal(1.25) * t344).add_product(R::literal(1.25),
        t346);
    let post_v_x_dot_by_cylinder_phi = (R::literal(1.25) * t345).add_product(R::literal(-1.25),
        t347);
    let t348 = t247 + t136 + t137 - t249 + t253;
    let t349 = R::literal(3.333_333_333_333_333_5) * t251;
    let t350 = t349.add_product(t29, t348);
    let t351 = R::literal(3.333_333_333_333_333_5) * t252;
    let t352 = (-t351).add_product(t30, t348).sub_product(t78, t350);
    let t353 = (R::literal(2_777.777_777_777_778) * t348).add_product(t80, t350).sub_product(t89,
        t352);
    let t354 = (t255 - t149).sub_product(t27, t251).add_product(t28, t252).add_product(t31, t348)
        .add_product(t32, t244).sub_product(t33, t245).sub_product(t82, t350).sub_product(t91, t352)
        .add_product(t98, t353);
    let t355 = R::literal(5.0) * t244;
    let t356 = t355.add_product(t99, t353).add_product(t107, t354);
    let t357 = R::literal(5.0) * t245;
    let t358 = (-t357).add_product(t100, t353).add_product(t109, t354).sub_product(t116, t356);
    let t359 = (-(t84 * t350).add_product(t93, t352)).add_product(t102, t353).sub_product(t111,
        t354).sub_product(t118, t356).sub_product(t123, t358);
    let t360 = (-(t86 * t350).add_product(t95, t352)).add_product(t104, t353).sub_product(t113,
        t354).sub_product(t120, t356).sub_product(t125, t358).sub_product(t128, t359) * t129;
    let t361 = (t359 * t126).sub_product(t128, t360);
    let t362 = (t358 * t121).sub_product(t123, t361).sub_product(t125, t360);
    let t363 = (t356 * t114).add_product(t116, t362).add_product(t118, t361).add_product(t120,
        t360);
    let t364 = (t354 * t105).sub_product(t107, t363).add_product(t109, t362).sub_product(t111, t361)
        .sub_product(t113, t360);
    let t365 = (t353 * t96).add_product(t98, t364).sub_product(t99, t363).add_product(t100, t362)
        .add_product(t102, t361).add_product(t104, t360);
    let t366 = (t352 * t87).sub_product(t89, t365).sub_product(t91, t364).sub_product(t93, t361)
        .sub_product(t95, t360);
    let t367 = (t350 * t76).add_product(t78, t366).sub_product(t80, t365).add_product(t82, t364)
        .add_product(t84, t361).add_product(t86, t360);
    let t368 = (-(t69 * t366).add_product(t67, t367)).add_product(t72, t361).sub_product(t75, t360);
    let t369 = (-(t57 * t367).add_product(t55, t368).add_product(t58, t366).add_product(t61, t361))
        .add_product(t63, t360);
    let t370 = (t50 * t368).add_product(t48, t369);
    let t371 = (t42 * t369).sub_product(t40, t370).add_product(t40, t368);
    let bobbin_v_y_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t360;
    let bobbin_v_x_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t361;
    let rod_omega_dot_by_rod_x = (t34 * t363).sub_product(R::literal(4_166.666_666_666_667), t365)
        .sub_product(t35, t362);
    let rod_v_y_dot_by_rod_x = t357.sub_product(t33, t364).sub_product(R::literal(5.0), t362);
    let rod_v_x_dot_by_rod_x = t355.add_product(t32, t364).sub_product(R::literal(5.0), t363);
    let cylinder_omega_dot_by_rod_x = (t348 * R::literal(2_777.777_777_777_778)).sub_product(t29,
        t367).add_product(t30, t366).sub_product(R::literal(-2_777.777_777_777_778), t365)
        .add_product(t31, t364);
    let cylinder_v_y_dot_by_rod_x = t351.sub_product(R::literal(3.333_333_333_333_333_5), t366)
        .add_product(t28, t364);
    let cylinder_v_x_dot_by_rod_x = t349.sub_product(R::literal(3.333_333_333_333_333_5), t367)
        .sub_product(t27, t364);
    let plate_omega_dot_by_rod_x = (t24 * t368).sub_product(t23, t369).sub_product(t23, t367)
        .add_product(t24, t366).add_product(t25, t361).sub_product(t26, t360);
    let plate_v_y_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t366)
        .add_product(R::literal(-0.833_333_333_333_333_4), t368)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t360);
    let plate_v_x_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t367)
        .add_product(R::literal(-0.833_333_333_333_333_4), t369)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t361);
    let post_omega_dot_by_rod_x = (-(t22 * t370).add_product(t21, t371).add_product(t21, t369))
        .add_product(t22, t368);
    let post_v_y_dot_by_rod_x = (R::literal(1.25) * t368).add_product(R::literal(1.25), t370);
    let post_v_x_dot_by_rod_x = (R::literal(1.25) * t369).add_product(R::literal(-1.25), t371);
    let t372 = t284 - t283;
    let t373 = t287.add_product(t29, t372);
    let t374 = (-t289).add_product(t30, t372).sub_product(t78, t373);
    let t375 = (R::literal(2_777.777_777_777_778) * t372).add_product(t80, t373).sub_product(t89,
        t374);
    let t376 = ((t286 - t292 + t293).add_product(t31, t372) - t294 + t295).sub_product(t82, t373)
        .sub_product(t91, t374).add_product(t98, t375);
    let t377 = t297.sub_product(t99, t375).sub_product(t107, t376);
    let t378 = t299.add_product(t100, t375).add_product(t109, t376).add_product(t116, t377);
    let t379 = (-(t84 * t373).add_product(t93, t374)).add_product(t102, t375).sub_product(t111,
        t376).add_product(t118, t377).sub_product(t123, t378);
    let t380 = (-(t86 * t373).add_product(t95, t374)).add_product(t104, t375).sub_product(t113,
        t376).add_product(t120, t377).sub_product(t125, t378).sub_product(t128, t379) * t129;
    let t381 = (t379 * t126).sub_product(t128, t380);
    let t382 = (t378 * t121).sub_product(t123, t381).sub_product(t125, t380);
    let t383 = (-(t377 * t114)).add_product(t116, t382).add_product(t118, t381).add_product(t120,
        t380);
    let t384 = (t376 * t105).sub_product(t107, t383).add_product(t109, t382).sub_product(t111, t381)
        .sub_product(t113, t380);
    let t385 = (t375 * t96).add_product(t98, t384).sub_product(t99, t383).add_product(t100, t382)
        .add_product(t102, t381).add_product(t104, t380);
    let t386 = (t374 * t87).sub_product(t89, t385).sub_product(t91, t384).sub_product(t93, t381)
        .sub_product(t95, t380);
    let t387 = (t373 * t76).add_product(t78, t386).sub_product(t80, t385).add_product(t82, t384)
        .add_product(t84, t381).add_product(t86, t380);
    let t388 = (-(t69 * t386).add_product(t67, t387)).add_product(t72, t381).sub_product(t75, t380);
    let t389 = (-(t57 * t387).add_product(t55, t388).add_product(t58, t386).add_product(t61, t381))
        .add_product(t63, t380);
    let t390 = (t50 * t388).add_product(t48, t389);
    let t391 = (t42 * t389).sub_product(t40, t390).add_product(t40, t388);
    let bobbin_v_y_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t380;
    let bobbin_v_x_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t381;
    let rod_omega_dot_by_rod_y = (t34 * t383).sub_product(R::literal(4_166.666_666_666_667), t385)
        .sub_product(t35, t382);
    let rod_v_y_dot_by_rod_y = (-t299.add_product(t33, t384)).add_product(R::literal(-5.0), t382);
    let rod_v_x_dot_by_rod_y = (-t297).add_product(t32, t384).sub_product(R::literal(5.0), t383);
    let cylinder_omega_dot_by_rod_y = (t372 * R::literal(2_777.777_777_777_778)).sub_product(t29,
        t387).add_product(t30, t386).sub_product(R::literal(-2_777.777_777_777_778), t385)
        .add_product(t31, t384);
    let cylinder_v_y_dot_by_rod_y = t289.sub_product(R::literal(3.333_333_333_333_333_5), t386)
        .add_product(t28, t384);
    let cylinder_v_x_dot_by_rod_y = t287.sub_product(R::literal(3.333_333_333_333_333_5), t387)
        .sub_product(t27, t384);
    let plate_omega_dot_by_rod_y = (t24 * t388).sub_product(t23, t389).sub_product(t23, t387)
        .add_product(t24, t386).add_product(t25, t381).sub_product(t26, t380);
    let plate_v_y_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t386)
        .add_product(R::literal(-0.833_333_333_333_333_4), t388)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t380);
    let plate_v_x_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t387)
        .add_product(R::literal(-0.833_333_333_333_333_4), t389)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t381);
    let post_omega_dot_by_rod_y = (-(t22 * t390).add_product(t21, t391).add_product(t21, t389))
        .add_product(t22, t388);
    let post_v_y_dot_by_rod_y = (R::literal(1.25) * t388).add_product(R::literal(1.25), t390);
    let post_v_x_dot_by_rod_y = (R::literal(1.25) * t389).add_product(R::literal(-1.25), t391);
    let t392 = (t7 * t183).add_product(t6, t184);
    let t393 = R::literal(4_166.666_666_666_667) * t392;
    let t394 = t98 * t393;
    let t395 = (-t160).add_product(t6, rod_omega_dot).add_product(t34, t392).add_product(t99, t393)
        .add_product(t107, t394);
    let t396 = t159.add_product(t7, rod_omega_dot).sub_product(t35, t392).sub_product(t100, t393)
        .sub_product(t109, t394).add_product(t116, t395);
    let t397 = (-(t102 * t393)).add_product(t111, t394).add_product(t118, t395).sub_product(t123,
        t396);
    let t398 = (-(t104 * t393)).add_product(t113, t394).add_product(t120, t395).sub_product(t125,
        t396).sub_product(t128, t397) * t129;
    let t399 = (t397 * t126).sub_product(t128, t398);
    let t400 = (t396 * t121).sub_product(t123, t399).sub_product(t125, t398);
    let t401 = (-(t395 * t114)).add_product(t116, t400).add_product(t118, t399).add_product(t120,
        t398);
    let t402 = (-(t394 * t105).add_product(t107, t401)).add_product(t109, t400).sub_product(t111,
        t399).sub_product(t113, t398);
    let t403 = (-(t393 * t96)).add_product(t98, t402).sub_product(t99, t401).add_product(t100, t400)
        .add_product(t102, t399).add_product(t104, t398);
    let t404 = (t91 * t402).add_product(t89, t403).add_product(t93, t399).add_product(t95, t398);
    let t405 = (-(t80 * t403).add_product(t78, t404)).add_product(t82, t402).add_product(t84, t399)
        .add_product(t86, t398);
    let t406 = (t69 * t404).sub_product(t67, t405).add_product(t72, t399).sub_product(t75, t398);
    let t407 = (-(t57 * t405).add_product(t55, t406)).add_product(t58, t404).sub_product(t61, t399)
        .add_product(t63, t398);
    let t408 = (t50 * t406).add_product(t48, t407);
    let t409 = (t42 * t407).sub_product(t40, t408).add_product(t40, t406);
    let bobbin_v_y_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t398;
    let bobbin_v_x_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t399;
    let rod_omega_dot_by_rod_phi = t393.sub_product(R::literal(4_166.666_666_666_667), t403)
        .add_product(t34, t401).sub_product(t35, t400);
    let rod_v_y_dot_by_rod_phi = (R::literal(-5.0) * t400).sub_product(t33, t402);
    let rod_v_x_dot_by_rod_phi = (R::literal(-5.0) * t401).add_product(t32, t402);
    let cylinder_omega_dot_by_rod_phi = (-(t30 * t404).add_product(t29, t405)
        .add_product(R::literal(-2_777.777_777_777_778), t403)).add_product(t31, t402);
    let cylinder_v_y_dot_by_rod_phi = (t28 * t402).add_product(R::literal(3.333_333_333_333_333_5),
        t404);
    let cylinder_v_x_dot_by_rod_phi = (-(t27 * t402))
        .add_product(R::literal(-3.333_333_333_333_333_5), t405);
    let plate_omega_dot_by_rod_phi = (t24 * t406).sub_product(t23, t407).sub_product(t23, t405)
        .sub_product(t24, t404).add_product(t25, t399).sub_product(t26, t398);
    let plate_v_y_dot_by_rod_phi = (R::literal(-0.833_333_333_333_333_4) * t404)
        .sub_product(R::literal(0.833_333_333_333_333_4), t406)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t398);
    let plate_v_x_dot_by_rod_phi = (R::literal(0.833_333_333_333_333_4) * t405)
        .add_product(R::literal(-0.833_333_333_333_333_4), t407)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t399);
    let post_omega_dot_by_rod_phi = (-(t22 * t408).add_product(t21, t409).add_product(t21, t407))
        .add_product(t22, t406);
    let post_v_y_dot_by_rod_phi = (R::literal(1.25) * t406).add_product(R::literal(1.25), t408);
    let post_v_x_dot_by_rod_phi = (R::literal(1.25) * t407).add_product(R::literal(-1.25), t409);
    let between_squared = between * between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t410 = contact_stiffness_times_contact_gap / between;
    let t411 = contact_damping_times_contact_rate / between;
    let between_squared_times_between = between_squared * between;
    let t412 = c.t0 * contact_rate;
    let t413 = t412 * t11 * t13 / between_squared_times_between;
    let t414 = t141 * t13 / between_squared_times_between;
    let t415 = p.contact_stiffness * t11 * t13 / between_squared;
    let t416 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t412 * t12 / between_squared_times_between
        + contact_stiffness_times_contact_gap * t12 / between_squared_times_between
        - contact_damping_times_bobbin_v_x * t11 / between_squared - t410 - p.contact_stiffness
        * t12 / between_squared - t411);
    let t417 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t413 - contact_damping_times_bobbin_v_x * t13
        / between_squared - (t415 - t414));
    let t418 = (-t417).add_product(t128, t416) * t129;
    let t419 = (t416 * t126).add_product(t128, t418);
    let t420 = (-(t125 * t418)).add_product(t123, t419);
    let t421 = (-(t118 * t419)).add_product(t116, t420).add_product(t120, t418);
    let t422 = (t109 * t420).sub_product(t107, t421).add_product(t111, t419).sub_product(t113,
        t418);
    let t423 = (-(t99 * t421)).add_product(t98, t422).add_product(t100, t420).sub_product(t102,
        t419).add_product(t104, t418);
    let t424 = (-(t91 * t422).add_product(t89, t423)).add_product(t93, t419).sub_product(t95, t418);
    let t425 = (-(t80 * t423)).add_product(t78, t424).add_product(t82, t422).sub_product(t84, t419)
        .add_product(t86, t418);
    let t426 = (t69 * t424).add_product(t67, t425).add_product(t72, t419).add_product(t75, t418);
    let t427 = (-(t57 * t425)).add_product(t55, t426).sub_product(t58, t424).add_product(t61, t419)
        .add_product(t63, t418);
    let t428 = (t50 * t426).sub_product(t48, t427);
    let t429 = (t42 * t427).add_product(t40, t428).sub_product(t40, t426);
    let bobbin_v_y_dot_by_bobbin_x = t417.sub_product(R::literal(1.428_571_428_571_428_6), t418);
    let bobbin_v_x_dot_by_bobbin_x = t416.add_product(R::literal(1.428_571_428_571_428_6), t419);
    let rod_omega_dot_by_bobbin_x = (t34 * t421).sub_product(R::literal(4_166.666_666_666_667),
        t423).sub_product(t35, t420);
    let rod_v_y_dot_by_bobbin_x = (R::literal(-5.0) * t420).sub_product(t33, t422);
    let rod_v_x_dot_by_bobbin_x = (R::literal(-5.0) * t421).add_product(t32, t422);
    let cylinder_omega_dot_by_bobbin_x = (t30 * t424).sub_product(t29, t425)
        .sub_product(R::literal(-2_777.777_777_777_778), t423).add_product(t31, t422);
    let cylinder_v_y_dot_by_bobbin_x = (t28 * t422)
        .sub_product(R::literal(3.333_333_333_333_333_5), t424);
    let cylinder_v_x_dot_by_bobbin_x = (-(t27 * t422))
        .add_product(R::literal(-3.333_333_333_333_333_5), t425);
    let plate_omega_dot_by_bobbin_x = (-(t24 * t426).add_product(t23, t427).add_product(t23, t425))
        .add_product(t24, t424).sub_product(t25, t419).sub_product(t26, t418);
    let plate_v_y_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t424)
        .add_product(R::literal(0.833_333_333_333_333_4), t426)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t418);
    let plate_v_x_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t425)
        .add_product(R::literal(0.833_333_333_333_333_4), t427))
        .add_product(R::literal(-0.833_333_333_333_333_4), t419);
    let post_omega_dot_by_bobbin_x = (t22 * t428).sub_product(t21, t429).sub_product(t21, t427)
        .sub_product(t22, t426);
    let post_v_y_dot_by_bobbin_x = (R::literal(-1.25) * t426).sub_product(R::literal(1.25), t428);
    let post_v_x_dot_by_bobbin_x = (R::literal(1.25) * t427).add_product(R::literal(-1.25), t429);
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t430 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t413 + t414 - contact_damping_times_bobbin_v_y * t11
        / between_squared - t415);
    let t431 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t412 * t14 / between_squared_times_between
        - contact_damping_times_bobbin_v_y * t13 / between_squared - t411
        - (t410 + p.contact_stiffness * t14 / between_squared - contact_stiffness_times_contact_gap
        * t14 / between_squared_times_between));
    let t432 = (-t431).add_product(t128, t430) * t129;
    let t433 = (t430 * t126).add_product(t128, t432);
    let t434 = (-(t125 * t432)).add_product(t123, t433);
    let t435 = (-(t118 * t433)).add_product(t116, t434).add_product(t120, t432);
    let t436 = (t109 * t434).sub_product(t107, t435).add_product(t111, t433).sub_product(t113,
        t432);
    let t437 = (-(t99 * t435)).add_product(t98, t436).add_product(t100, t434).sub_product(t102,
        t433).add_product(t104, t432);
    let t438 = (-(t91 * t436).add_product(t89, t437)).add_product(t93, t433).sub_product(t95, t432);
    let t439 = (-(t80 * t437)).add_product(t78, t438).add_product(t82, t436).sub_product(t84, t433)
        .add_product(t86, t432);
    let t440 = (t69 * t438).add_product(t67, t439).add_product(t72, t433).add_product(t75, t432);
    let t441 = (-(t57 * t439)).add_product(t55, t440).sub_product(t58, t438).add_product(t61, t433)
        .add_product(t63, t432);
    let t442 = (t50 * t440).sub_product(t48, t441);
    let t443 = (t42 * t441).add_product(t40, t442).sub_product(t40, t440);
    let bobbin_v_y_dot_by_bobbin_y = t431.sub_product(R::literal(1.428_571_428_571_428_6), t432);
    let bobbin_v_x_dot_by_bobbin_y = t430.add_product(R::literal(1.428_571_428_571_428_6), t433);
    let rod_omega_dot_by_bobbin_y = (t34 * t435).sub_product(R::literal(4_166.666_666_666_667),
        t437).sub_product(t35, t434);
    let rod_v_y_dot_by_bobbin_y = (R::literal(-5.0) * t434).sub_product(t33, t436);
    let rod_v_x_dot_by_bobbin_y = (R::literal(-5.0) * t435).add_product(t32, t436);
    let cylinder_omega_dot_by_bobbin_y = (t30 * t438).sub_product(t29, t439)
        .sub_product(R::literal(-2_777.777_777_777_778), t437).add_product(t31, t436);
    let cylinder_v_y_dot_by_bobbin_y = (t28 * t436)
        .sub_product(R::literal(3.333_333_333_333_333_5), t438);
    let cylinder_v_x_dot_by_bobbin_y = (-(t27 * t436))
        .add_product(R::literal(-3.333_333_333_333_333_5), t439);
    let plate_omega_dot_by_bobbin_y = (-(t24 * t440).add_product(t23, t441).add_product(t23, t439))
        .add_product(t24, t438).sub_product(t25, t433).sub_product(t26, t432);
    let plate_v_y_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t438)
        .add_product(R::literal(0.833_333_333_333_333_4), t440)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t432);
    let plate_v_x_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t439)
        .add_product(R::literal(0.833_333_333_333_333_4), t441))
        .add_product(R::literal(-0.833_333_333_333_333_4), t433);
    let post_omega_dot_by_bobbin_y = (t22 * t442).sub_product(t21, t443).sub_product(t21, t441)
        .sub_product(t22, t440);
    let post_v_y_dot_by_bobbin_y = (R::literal(-1.25) * t440).sub_product(R::literal(1.25), t442);
    let post_v_x_dot_by_bobbin_y = (R::literal(1.25) * t441).add_product(R::literal(-1.25), t443);
    let t444 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(-1500.0)
        * t193);
    let t445 = R::literal(0.2) * post_omega;
    let t446 = (t445 * cos_post_phi).add_product(t21, t444);
    let t447 = (-(t445 * sin_post_phi)).add_product(t22, t444).sub_product(t40, t446);
    let t448 = t446.add_product(t42, t446).add_product(t48, t447);
    let t449 = t447.sub_product(t50, t447).add_product(t55, t448);
    let t450 = (t57 * t448).sub_product(t67, t449);
    let t451 = (t58 * t448).sub_product(t69, t449).add_product(t78, t450);
    let t452 = (t80 * t450).add_product(t89, t451);
    let t453 = (t82 * t450).sub_product(t91, t451).sub_product(t98, t452);
    let t454 = (t99 * t452).sub_product(t107, t453);
    let t455 = (-(t100 * t452)).add_product(t109, t453).add_product(t116, t454);
    let t456 = (t61 * t448).add_product(t72, t449).add_product(t84, t450).sub_product(t93, t451)
        .sub_product(t102, t452).sub_product(t111, t453).add_product(t118, t454).sub_product(t123,
        t455);
    let t457 = (-(t63 * t448).add_product(t75, t449)).add_product(t86, t450).sub_product(t95, t451)
        .sub_product(t104, t452).sub_product(t113, t453).add_product(t120, t454).sub_product(t125,
        t455).sub_product(t128, t456) * t129;
    let t458 = (t456 * t126).sub_product(t128, t457);
    let t459 = (t455 * t121).sub_product(t123, t458).sub_product(t125, t457);
    let t460 = (-(t454 * t114)).add_product(t116, t459).add_product(t118, t458).add_product(t120,
        t457);
    let t461 = (t453 * t105).sub_product(t107, t460).add_product(t109, t459).sub_product(t111, t458)
        .sub_product(t113, t457);
    let t462 = (-(t452 * t96)).add_product(t98, t461).sub_product(t99, t460).add_product(t100, t459)
        .add_product(t102, t458).add_product(t104, t457);
    let t463 = (t451 * t87).sub_product(t89, t462).sub_product(t91, t461).sub_product(t93, t458)
        .sub_product(t95, t457);
    let t464 = (-(t450 * t76)).add_product(t78, t463).sub_product(t80, t462).add_product(t82, t461)
        .add_product(t84, t458).add_product(t86, t457);
    let t465 = (t449 * t65).sub_product(t67, t464).sub_product(t69, t463).add_product(t72, t458)
        .sub_product(t75, t457);
    let t466 = (-(t448 * t52).add_product(t55, t465).add_product(t57, t464).add_product(t58, t463)
        .add_product(t61, t458)).add_product(t63, t457);
    let t467 = (t447 * t46).sub_product(t48, t466).sub_product(t50, t465);
    let t468 = (t446 * t38).add_product(t40, t467).add_product(t42, t466).add_product(t40, t465);
    let bobbin_v_y_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t457;
    let bobbin_v_x_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t458;
    let rod_omega_dot_by_post_omega = (t34 * t460).sub_product(R::literal(4_166.666_666_666_667),
        t462).sub_product(t35, t459);
    let rod_v_y_dot_by_post_omega = (R::literal(-5.0) * t459).sub_product(t33, t461);
    let rod_v_x_dot_by_post_omega = (R::literal(-5.0) * t460).add_product(t32, t461);
    let cylinder_omega_dot_by_post_omega = (t30 * t463).sub_product(t29, t464)
        .sub_product(R::literal(-2_777.777_777_777_778), t462).add_product(t31, t461);
    let cylinder_v_y_dot_by_post_omega = (t28 * t461)
        .sub_product(R::literal(3.333_333_333_333_333_5), t463);
    let cylinder_v_x_dot_by_post_omega = (-(t27 * t461))
        .add_product(R::literal(-3.333_333_333_333_333_5), t464);
    let plate_omega_dot_by_post_omega = (t24 * t465).sub_product(t23, t466).sub_product(t23, t464)
        .add_product(t24, t463).add_product(t25, t458).sub_product(t26, t457);
    let plate_v_y_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t463)
        .add_product(R::literal(-0.833_333_333_333_333_4), t465)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t457);
    let plate_v_x_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t464)
        .add_product(R::literal(-0.833_333_333_333_333_4), t466)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t458);
    let post_omega_dot_by_post_omega = (t444 * R::literal(370.370_370_370_370_3)).sub_product(t21,
        t468).add_product(t22, t467).sub_product(t21, t466).add_product(t22, t465);
    let post_v_y_dot_by_post_omega = (R::literal(1.25) * t465).add_product(R::literal(-1.25), t467);
    let post_v_x_dot_by_post_omega = (R::literal(1.25) * t466).add_product(R::literal(-1.25), t468);
    let t469 = R::literal(0.12) * plate_omega;
    let t470 = t469 * cos_plate_phi;
    let t471 = t469 * sin_plate_phi;
    let t472 = (-t471).add_product(t55, t470);
    let t473 = (-t470).add_product(t57, t470).sub_product(t67, t472);
    let t474 = (-t471).add_product(t58, t470).sub_product(t69, t472).add_product(t78, t473);
    let t475 = (t80 * t473).add_product(t89, t474);
    let t476 = (t82 * t473).sub_product(t91, t474).sub_product(t98, t475);
    let t477 = (t99 * t475).sub_product(t107, t476);
    let t478 = (-(t100 * t475)).add_product(t109, t476).add_product(t116, t477);
    let t479 = (plate_omega * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2),
        sin_plate_phi)).add_product(t61, t470).add_product(t72, t472).add_product(t84, t473)
        .sub_product(t93, t474).sub_product(t102, t475).sub_product(t111, t476).add_product(t118,
        t477).sub_product(t123, t478);
    let t480 = (plate_omega * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2),
        cos_plate_phi)).sub_product(t63, t470).sub_product(t75, t472).add_product(t86, t473)
        .sub_product(t95, t474).sub_product(t104, t475).sub_product(t113, t476).add_product(t120,
        t477).sub_product(t125, t478).sub_product(t128, t479) * t129;
    let t481 = (t479 * t126).sub_product(t128, t480);
    let t482 = (t478 * t121).sub_product(t123, t481).sub_product(t125, t480);
    let t483 = (-(t477 * t114)).add_product(t116, t482).add_product(t118, t481).add_product(t120,
        t480);
    let t484 = (t476 * t105).sub_product(t107, t483).add_product(t109, t482).sub_product(t111, t481)
        .sub_product(t113, t480);
    let t485 = (-(t475 * t96)).add_product(t98, t484).sub_product(t99, t483).add_product(t100, t482)
        .add_product(t102, t481).add_product(t104, t480);
    let t486 = (t474 * t87).sub_product(t89, t485).sub_product(t91, t484).sub_product(t93, t481)
        .sub_product(t95, t480);
    let t487 = (-(t473 * t76)).add_product(t78, t486).sub_product(t80, t485).add_product(t82, t484)
        .add_product(t84, t481).add_product(t86, t480);
    let t488 = (t472 * t65).sub_product(t67, t487).sub_product(t69, t486).add_product(t72, t481)
        .sub_product(t75, t480);
    let t489 = (-(t470 * t52).add_product(t55, t488).add_product(t57, t487).add_product(t58, t486)
        .add_product(t61, t481)).add_product(t63, t480);
    let t490 = (t50 * t488).add_product(t48, t489);
    let t491 = (t42 * t489).sub_product(t40, t490).add_product(t40, t488);
    let bobbin_v_y_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t480;
    let bobbin_v_x_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t481;
    let rod_omega_dot_by_plate_omega = (t34 * t483).sub_product(R::literal(4_166.666_666_666_667),
        t485).sub_product(t35, t482);
    let rod_v_y_dot_by_plate_omega = (R::literal(-5.0) * t482).sub_product(t33, t484);
    let rod_v_x_dot_by_plate_omega = (R::literal(-5.0) * t483).add_product(t32, t484);
    let cylinder_omega_dot_by_plate_omega = (t30 * t486).sub_product(t29, t487)
        .sub_product(R::literal(-2_777.777_777_777_778), t485).add_product(t31, t484);
    let cylinder_v_y_dot_by_plate_omega = (t28 * t484)
        .sub_product(R::literal(3.333_333_333_333_333_5), t486);
    let cylinder_v_x_dot_by_plate_omega = (-(t27 * t484))
        .add_product(R::literal(-3.333_333_333_333_333_5), t487);
    let plate_omega_dot_by_plate_omega = (t24 * t488).sub_product(t23, t489).sub_product(t23, t487)
        .add_product(t24, t486).add_product(t25, t481).sub_product(t26, t480);
    let plate_v_y_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t486)
        .add_product(R::literal(-0.833_333_333_333_333_4), t488)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t480);
    let plate_v_x_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t487)
        .add_product(R::literal(-0.833_333_333_333_333_4), t489)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t481);
    let post_omega_dot_by_plate_omega = (-(t22 * t490).add_product(t21, t491).add_product(t21,
        t489)).add_product(t22, t488);
    let post_v_y_dot_by_plate_omega = (R::literal(1.25) * t488).add_product(R::literal(1.25), t490);
    let post_v_x_dot_by_plate_omega = (R::literal(1.25) * t489).add_product(R::literal(-1.25),
        t491);
    let t492 = p.spring_damping * (cos_cylinder_phi * cos_cylinder_phi);
    let t493 = p.spring_damping * sin_cylinder_phi * cos_cylinder_phi;
    let t494 = p.spring_damping * t17;
    let t495 = t494 * cos_cylinder_phi;
    let t496 = R::literal(2.0) * cylinder_omega;
    let t497 = t496 * cos_cylinder_phi;
    let t498 = R::literal(3.333_333_333_333_333_5) * t492;
    let t499 = t29 * t495;
    let t500 = t498 - t499;
    let t501 = R::literal(3.333_333_333_333_333_5) * t493;
    let t502 = t501.add_product(t30, t495);
    let t503 = t502.add_product(t78, t500);
    let t504 = R::literal(-2_777.777_777_777_778) * t495;
    let t505 = t504.add_product(t80, t500).add_product(t89, t503);
    let t506 = t27 * t492;
    let t507 = t28 * t493;
    let t508 = t31 * t495;
    let t509 = t32 * t492;
    let t510 = t33 * t493;
    let t511 = (t506 - t497 - t507 + t508 + t509 - t510).add_product(t82, t500).sub_product(t91,
        t503).sub_product(t98, t505);
    let t512 = R::literal(5.0) * t492;
    let t513 = (-t512).add_product(t99, t505).sub_product(t107, t511);
    let t514 = R::literal(5.0) * t493;
    let t515 = (-t514.add_product(t100, t505)).add_product(t109, t511).add_product(t116, t513);
    let t516 = (t84 * t500).sub_product(t93, t503).sub_product(t102, t505).sub_product(t111, t511)
        .add_product(t118, t513).sub_product(t123, t515);
    let t517 = t495 * R::literal(2_777.777_777_777_778);
    let t518 = (t86 * t500).sub_product(t95, t503).sub_product(t104, t505).sub_product(t113, t511)
        .add_product(t120, t513).sub_product(t125, t515).sub_product(t128, t516) * t129;
    let t519 = (t516 * t126).sub_product(t128, t518);
    let t520 = (t515 * t121).sub_product(t123, t519).sub_product(t125, t518);
    let t521 = (-(t513 * t114)).add_product(t116, t520).add_product(t118, t519).add_product(t120,
        t518);
    let t522 = (t511 * t105).sub_product(t107, t521).add_product(t109, t520).sub_product(t111, t519)
        .sub_product(t113, t518);
    let t523 = (-(t505 * t96)).add_product(t98, t522).sub_product(t99, t521).add_product(t100, t520)
        .add_product(t102, t519).add_product(t104, t518);
    let t524 = (t503 * t87).sub_product(t89, t523).sub_product(t91, t522).sub_product(t93, t519)
        .sub_product(t95, t518);
    let t525 = (-(t500 * t76)).add_product(t78, t524).sub_product(t80, t523).add_product(t82, t522)
        .add_product(t84, t519).add_product(t86, t518);
    let t526 = (-(t69 * t524).add_product(t67, t525)).add_product(t72, t519).sub_product(t75, t518);
    let t527 = (-(t57 * t525).add_product(t55, t526).add_product(t58, t524).add_product(t61, t519))
        .add_product(t63, t518);
    let t528 = (t50 * t526).add_product(t48, t527);
    let t529 = (t42 * t527).sub_product(t40, t528).add_product(t40, t526);
    let bobbin_v_y_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t518;
    let bobbin_v_x_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t519;
    let rod_omega_dot_by_cylinder_v_x = (t34 * t521).sub_product(R::literal(4_166.666_666_666_667),
        t523).sub_product(t35, t520);
    let rod_v_y_dot_by_cylinder_v_x = t514.sub_product(t33, t522).sub_product(R::literal(5.0),
        t520);
    let rod_v_x_dot_by_cylinder_v_x = t512.add_product(t32, t522).sub_product(R::literal(5.0),
        t521);
    let cylinder_omega_dot_by_cylinder_v_x = t517.sub_product(t29, t525).add_product(t30, t524)
        .sub_product(R::literal(-2_777.777_777_777_778), t523).add_product(t31, t522);
    let cylinder_v_y_dot_by_cylinder_v_x = (-t501.add_product(R::literal(3.333_333_333_333_333_5),
        t524)).add_product(t28, t522);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t498)
        .add_product(R::literal(-3.333_333_333_333_333_5), t525).sub_product(t27, t522);
    let plate_omega_dot_by_cylinder_v_x = (t24 * t526).sub_product(t23, t527).sub_product(t23, t525)
        .add_product(t24, t524).add_product(t25, t519).sub_product(t26, t518);
    let plate_v_y_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t524)
        .add_product(R::literal(-0.833_333_333_333_333_4), t526)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t518);
    let plate_v_x_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t525)
        .add_product(R::literal(-0.833_333_333_333_333_4), t527)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t519);
    let post_omega_dot_by_cylinder_v_x = (-(t22 * t528).add_product(t21, t529).add_product(t21,
        t527)).add_product(t22, t526);
    let post_v_y_dot_by_cylinder_v_x = (R::literal(1.25) * t526).add_product(R::literal(1.25),
        t528);
    let post_v_x_dot_by_cylinder_v_x = (R::literal(1.25) * t527).add_product(R::literal(-1.25),
        t529);
    let t530 = p.spring_damping * (sin_cylinder_phi * sin_cylinder_phi);
    let t531 = t494 * sin_cylinder_phi;
    let t532 = t496 * sin_cylinder_phi;
    let t533 = t29 * t531;
    let t534 = t501 - t533;
    let t535 = R::literal(3.333_333_333_333_333_5) * t530;
    let t536 = t535.add_product(t30, t531);
    let t537 = t536.add_product(t78, t534);
    let t538 = R::literal(-2_777.777_777_777_778) * t531;
    let t539 = t538.add_product(t80, t534).add_product(t89, t537);
    let t540 = t27 * t493;
    let t541 = t28 * t530;
    let t542 = t31 * t531;
    let t543 = t32 * t493;
    let t544 = t33 * t530;
    let t545 = (t540 - t532 - t541 + t542 + t543 - t544).add_product(t82, t534).sub_product(t91,
        t537).sub_product(t98, t539);
    let t546 = (-t514).add_product(t99, t539).sub_product(t107, t545);
    let t547 = R::literal(5.0) * t530;
    let t548 = (-t547.add_product(t100, t539)).add_product(t109, t545).add_product(t116, t546);
    let t549 = (t84 * t534).sub_product(t93, t537).sub_product(t102, t539).sub_product(t111, t545)
        .add_product(t118, t546).sub_product(t123, t548);
    let t550 = t531 * R::literal(2_777.777_777_777_778);
    let t551 = (t86 * t534).sub_product(t95, t537).sub_product(t104, t539).sub_product(t113, t545)
        .add_product(t120, t546).sub_product(t125, t548).sub_product(t128, t549) * t129;
    let t552 = (t549 * t126).sub_product(t128, t551);
    let t553 = (t548 * t121).sub_product(t123, t552).sub_product(t125, t551);
    let t554 = (-(t546 * t114)).add_product(t116, t553).add_product(t118, t552).add_product(t120,
        t551);
    let t555 = (t545 * t105).sub_product(t107, t554).add_product(t109, t553).sub_product(t111, t552)
        .sub_product(t113, t551);
    let t556 = (-(t539 * t96)).add_product(t98, t555).sub_product(t99, t554).add_product(t100, t553)
        .add_product(t102, t552).add_product(t104, t551);
    let t557 = (t537 * t87).sub_product(t89, t556).sub_product(t91, t555).sub_product(t93, t552)
        .sub_product(t95, t551);
    let t558 = (-(t534 * t76)).add_product(t78, t557).sub_product(t80, t556).add_product(t82, t555)
        .add_product(t84, t552).add_product(t86, t551);
    let t559 = (-(t69 * t557).add_product(t67, t558)).add_product(t72, t552).sub_product(t75, t551);
    let t560 = (-(t57 * t558).add_product(t55, t559).add_product(t58, t557).add_product(t61, t552))
        .add_product(t63, t551);
    let t561 = (t50 * t559).add_product(t48, t560);
    let t562 = (t42 * t560).sub_product(t40, t561).add_product(t40, t559);
    let bobbin_v_y_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t551;
    let bobbin_v_x_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t552;
    let rod_omega_dot_by_cylinder_v_y = (t34 * t554).sub_product(R::literal(4_166.666_666_666_667),
        t556).sub_product(t35, t553);
    let rod_v_y_dot_by_cylinder_v_y = t547.sub_product(t33, t555).sub_product(R::literal(5.0),
        t553);
    let rod_v_x_dot_by_cylinder_v_y = t514.add_product(t32, t555).sub_product(R::literal(5.0),
        t554);
    let cylinder_omega_dot_by_cylinder_v_y = t550.sub_product(t29, t558).add_product(t30, t557)
        .sub_product(R::literal(-2_777.777_777_777_778), t556).add_product(t31, t555);
    let cylinder_v_y_dot_by_cylinder_v_y = (-t535.add_product(R::literal(3.333_333_333_333_333_5),
        t557)).add_product(t28, t555);
    let cylinder_v_x_dot_by_cylinder_v_y = (-t501)
        .add_product(R::literal(-3.333_333_333_333_333_5), t558).sub_product(t27, t555);
    let plate_omega_dot_by_cylinder_v_y = (t24 * t559).sub_product(t23, t560).sub_product(t23, t558)
        .add_product(t24, t557).add_product(t25, t552).sub_product(t26, t551);
    let plate_v_y_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t557)
        .add_product(R::literal(-0.833_333_333_333_333_4), t559)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t551);
    let plate_v_x_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t558)
        .add_product(R::literal(-0.833_333_333_333_333_4), t560)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t552);
    let post_omega_dot_by_cylinder_v_y = (-(t22 * t561).add_product(t21, t562).add_product(t21,
        t560)).add_product(t22, t559);
    let post_v_y_dot_by_cylinder_v_y = (R::literal(1.25) * t559).add_product(R::literal(1.25),
        t561);
    let post_v_x_dot_by_cylinder_v_y = (R::literal(1.25) * t560).add_product(R::literal(-1.25),
        t562);
    let t563 = p.spring_damping * t317;
    let t564 = R::literal(0.12) * cylinder_omega;
    let t565 = R::literal(3.333_333_333_333_333_5) * t495;
    let t566 = (-t565.add_product(t564, cos_cylinder_phi)).add_product(t29, t563);
    let t567 = R::literal(3.333_333_333_333_333_5) * t531;
    let t568 = (-t567.add_product(t564, sin_cylinder_phi).add_product(t30, t563)).add_product(t78,
        t566);
    let t569 = (R::literal(-2_777.777_777_777_778) * t563).sub_product(t80, t566).sub_product(t89,
        t568);
    let t570 = (-(t27 * t495)).add_product(R::literal(2.0), ((t156 + t157).add_product(rod_v_x,
        cos_cylinder_phi).add_product(rod_v_y, sin_cylinder_phi) - t152 - t153)
        .sub_product(cylinder_v_x, cos_cylinder_phi).sub_product(cylinder_v_y, sin_cylinder_phi))
        .add_product(t28, t531).sub_product(t31, t563).sub_product(t32, t495).add_product(t33, t531)
        .add_product(t82, t566).sub_product(t91, t568).add_product(t98, t569);
    let t571 = R::literal(5.0) * t495;
    let t572 = t571.sub_product(t99, t569).sub_product(t107, t570);
    let t573 = R::literal(5.0) * t531;
    let t574 = t573.add_product(t100, t569).add_product(t109, t570).add_product(t116, t572);
    let t575 = (t84 * t566).sub_product(t93, t568).add_product(t102, t569).sub_product(t111, t570)
        .add_product(t118, t572).sub_product(t123, t574);
    let t576 = (t86 * t566).sub_product(t95, t568).add_product(t104, t569).sub_product(t113, t570)
        .add_product(t120, t572).sub_product(t125, t574).sub_product(t128, t575) * t129;
    let t577 = (t575 * t126).sub_product(t128, t576);
    let t578 = (t574 * t121).sub_product(t123, t577).sub_product(t125, t576);
    let t579 = (-(t572 * t114)).add_product(t116, t578).add_product(t118, t577).add_product(t120,
        t576);
    let t580 = (t570 * t105).sub_product(t107, t579).add_product(t109, t578).sub_product(t111, t577)
        .sub_product(t113, t576);
    let t581 = (t569 * t96).add_product(t98, t580).sub_product(t99, t579).add_product(t100, t578)
        .add_product(t102, t577).add_product(t104, t576);
    let t582 = (t568 * t87).sub_product(t89, t581).sub_product(t91, t580).sub_product(t93, t577)
        .sub_product(t95, t576);
    let t583 = (-(t566 * t76)).add_product(t78, t582).sub_product(t80, t581).add_product(t82, t580)
        .add_product(t84, t577).add_product(t86, t576);
    let t584 = (-(t69 * t582).add_product(t67, t583)).add_product(t72, t577).sub_product(t75, t576);
    let t585 = (-(t57 * t583).add_product(t55, t584).add_product(t58, t582).add_product(t61, t577))
        .add_product(t63, t576);
    let t586 = (t50 * t584).add_product(t48, t585);
    let t587 = (t42 * t585).sub_product(t40, t586).add_product(t40, t584);
    let bobbin_v_y_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t576;
    let bobbin_v_x_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t577;
    let rod_omega_dot_by_cylinder_omega = (t34 * t579)
        .sub_product(R::literal(4_166.666_666_666_667), t581).sub_product(t35, t578);
    let rod_v_y_dot_by_cylinder_omega = (-t573.add_product(t33, t580))
        .add_product(R::literal(-5.0), t578);
    let rod_v_x_dot_by_cylinder_omega = (-t571).add_product(t32, t580).sub_product(R::literal(5.0),
        t579);
    let cylinder_omega_dot_by_cylinder_omega = (-(t563 * R::literal(2_777.777_777_777_778))
        .add_product(t29, t583)).add_product(t30, t582)
        .sub_product(R::literal(-2_777.777_777_777_778), t581).add_product(t31, t580);
    let cylinder_v_y_dot_by_cylinder_omega = t567.sub_product(R::literal(3.333_333_333_333_333_5),
        t582).add_product(t28, t580);
    let cylinder_v_x_dot_by_cylinder_omega = t565.sub_product(R::literal(3.333_333_333_333_333_5),
        t583).sub_product(t27, t580);
    let plate_omega_dot_by_cylinder_omega = (t24 * t584).sub_product(t23, t585).sub_product(t23,
        t583).add_product(t24, t582).add_product(t25, t577).sub_product(t26, t576);
    let plate_v_y_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t582)
        .add_product(R::literal(-0.833_333_333_333_333_4), t584)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t576);
    let plate_v_x_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t583)
        .add_product(R::literal(-0.833_333_333_333_333_4), t585)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t577);
    let post_omega_dot_by_cylinder_omega = (-(t22 * t586).add_product(t21, t587).add_product(t21,
        t585)).add_product(t22, t584);
    let post_v_y_dot_by_cylinder_omega = (R::literal(1.25) * t584).add_product(R::literal(1.25),
        t586);
    let post_v_x_dot_by_cylinder_omega = (R::literal(1.25) * t585).add_product(R::literal(-1.25),
        t587);
    let t588 = t499 - t498;
    let t589 = (-t502).add_product(t78, t588);
    let t590 = t504.sub_product(t80, t588).sub_product(t89, t589);
    let t591 = (t497 - t506 + t507 - t508 - t509 + t510).add_product(t82, t588).sub_product(t91,
        t589).add_product(t98, t590);
    let t592 = t512.sub_product(t99, t590).sub_product(t107, t591);
    let t593 = t514.add_product(t100, t590).add_product(t109, t591).add_product(t116, t592);
    let t594 = (t84 * t588).sub_product(t93, t589).add_product(t102, t590).sub_product(t111, t591)
        .add_product(t118, t592).sub_product(t123, t593);
    let t595 = (t86 * t588).sub_product(t95, t589).add_product(t104, t590).sub_product(t113, t591)
        .add_product(t120, t592).sub_product(t125, t593).sub_product(t128, t594) * t129;
    let t596 = (t594 * t126).sub_product(t128, t595);
    let t597 = (t593 * t121).sub_product(t123, t596).sub_product(t125, t595);
    let t598 = (-(t592 * t114)).add_product(t116, t597).add_product(t118, t596).add_product(t120,
        t595);
    let t599 = (t591 * t105).sub_product(t107, t598).add_product(t109, t597).sub_product(t111, t596)
        .sub_product(t113, t595);
    let t600 = (t590 * t96).add_product(t98, t599).sub_product(t99, t598).add_product(t100, t597)
        .add_product(t102, t596).add_product(t104, t595);
    let t601 = (t589 * t87).sub_product(t89, t600).sub_product(t91, t599).sub_product(t93, t596)
        .sub_product(t95, t595);
    let t602 = (-(t588 * t76)).add_product(t78, t601).sub_product(t80, t600).add_product(t82, t599)
        .add_product(t84, t596).add_product(t86, t595);
    let t603 = (-(t69 * t601).add_product(t67, t602)).add_product(t72, t596).sub_product(t75, t595);
    let t604 = (-(t57 * t602).add_product(t55, t603).add_product(t58, t601).add_product(t61, t596))
        .add_product(t63, t595);
    let t605 = (t50 * t603).add_product(t48, t604);
    let t606 = (t42 * t604).sub_product(t40, t605).add_product(t40, t603);
    let bobbin_v_y_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t595;
    let bobbin_v_x_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t596;
    let rod_omega_dot_by_rod_v_x = (t34 * t598).sub_product(R::literal(4_166.666_666_666_667), t600)
        .sub_product(t35, t597);
    let rod_v_y_dot_by_rod_v_x = (-t514.add_product(t33, t599)).add_product(R::literal(-5.0), t597);
    let rod_v_x_dot_by_rod_v_x = (-t512).add_product(t32, t599).sub_product(R::literal(5.0), t598);
    let cylinder_omega_dot_by_rod_v_x = (-t517.add_product(t29, t602)).add_product(t30, t601)
        .sub_product(R::literal(-2_777.777_777_777_778), t600).add_product(t31, t599);
    let cylinder_v_y_dot_by_rod_v_x = t501.sub_product(R::literal(3.333_333_333_333_333_5), t601)
        .add_product(t28, t599);
    let cylinder_v_x_dot_by_rod_v_x = t498.sub_product(R::literal(3.333_333_333_333_333_5), t602)
        .sub_product(t27, t599);
    let plate_omega_dot_by_rod_v_x = (t24 * t603).sub_product(t23, t604).sub_product(t23, t602)
        .add_product(t24, t601).add_product(t25, t596).sub_product(t26, t595);
    let plate_v_y_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t601)
        .add_product(R::literal(-0.833_333_333_333_333_4), t603)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t595);
    let plate_v_x_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t602)
        .add_product(R::literal(-0.833_333_333_333_333_4), t604)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t596);
    let post_omega_dot_by_rod_v_x = (-(t22 * t605).add_product(t21, t606).add_product(t21, t604))
        .add_product(t22, t603);
    let post_v_y_dot_by_rod_v_x = (R::literal(1.25) * t603).add_product(R::literal(1.25), t605);
    let post_v_x_dot_by_rod_v_x = (R::literal(1.25) * t604).add_product(R::literal(-1.25), t606);
    let t607 = t533 - t501;
    let t608 = (-t536).add_product(t78, t607);
    let t609 = t538.sub_product(t80, t607).sub_product(t89, t608);
    let t610 = (t532 - t540 + t541 - t542 - t543 + t544).add_product(t82, t607).sub_product(t91,
        t608).add_product(t98, t609);
    let t611 = t514.sub_product(t99, t609).sub_product(t107, t610);
    let t612 = t547.add_product(t100, t609).add_product(t109, t610).add_product(t116, t611);
    let t613 = (t84 * t607).sub_product(t93, t608).add_product(t102, t609).sub_product(t111, t610)
        .add_product(t118, t611).sub_product(t123, t612);
    let t614 = (t86 * t607).sub_product(t95, t608).add_product(t104, t609).sub_product(t113, t610)
        .add_product(t120, t611).sub_product(t125, t612).sub_product(t128, t613) * t129;
    let t615 = (t613 * t126).sub_product(t128, t614);
    let t616 = (t612 * t121).sub_product(t123, t615).sub_product(t125, t614);
    let t617 = (-(t611 * t114)).add_product(t116, t616).add_product(t118, t615).add_product(t120,
        t614);
    let t618 = (t610 * t105).sub_product(t107, t617).add_product(t109, t616).sub_product(t111, t615)
        .sub_product(t113, t614);
    let t619 = (t609 * t96).add_product(t98, t618).sub_product(t99, t617).add_product(t100, t616)
        .add_product(t102, t615).add_product(t104, t614);
    let t620 = (t608 * t87).sub_product(t89, t619).sub_product(t91, t618).sub_product(t93, t615)
        .sub_product(t95, t614);
    let t621 = (-(t607 * t76)).add_product(t78, t620).sub_product(t80, t619).add_product(t82, t618)
        .add_product(t84, t615).add_product(t86, t614);
    let t622 = (-(t69 * t620).add_product(t67, t621)).add_product(t72, t615).sub_product(t75, t614);
    let t623 = (-(t57 * t621).add_product(t55, t622).add_product(t58, t620).add_product(t61, t615))
        .add_product(t63, t614);
    let t624 = (t50 * t622).add_product(t48, t623);
    let t625 = (t42 * t623).sub_product(t40, t624).add_product(t40, t622);
    let bobbin_v_y_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t614;
    let bobbin_v_x_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t615;
    let rod_omega_dot_by_rod_v_y = (t34 * t617).sub_product(R::literal(4_166.666_666_666_667), t619)
        .sub_product(t35, t616);
    let rod_v_y_dot_by_rod_v_y = (-t547.add_product(t33, t618)).add_product(R::literal(-5.0), t616);
    let rod_v_x_dot_by_rod_v_y = (-t514).add_product(t32, t618).sub_product(R::literal(5.0), t617);
    let cylinder_omega_dot_by_rod_v_y = (-t550.add_product(t29, t621)).add_product(t30, t620)
        .sub_product(R::literal(-2_777.777_777_777_778), t619).add_product(t31, t618);
    let cylinder_v_y_dot_by_rod_v_y = t535.sub_product(R::literal(3.333_333_333_333_333_5), t620)
        .add_product(t28, t618);
    let cylinder_v_x_dot_by_rod_v_y = t501.sub_product(R::literal(3.333_333_333_333_333_5), t621)
        .sub_product(t27, t618);
    let plate_omega_dot_by_rod_v_y = (t24 * t622).sub_product(t23, t623).sub_product(t23, t621)
        .add_product(t24, t620).add_product(t25, t615).sub_product(t26, t614);
    let plate_v_y_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t620)
        .add_product(R::literal(-0.833_333_333_333_333_4), t622)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t614);
    let plate_v_x_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t621)
        .add_product(R::literal(-0.833_333_333_333_333_4), t623)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t615);
    let post_omega_dot_by_rod_v_y = (-(t22 * t624).add_product(t21, t625).add_product(t21, t623))
        .add_product(t22, t622);
    let post_v_y_dot_by_rod_v_y = (R::literal(1.25) * t622).add_product(R::literal(1.25), t624);
    let post_v_x_dot_by_rod_v_y = (R::literal(1.25) * t623).add_product(R::literal(-1.25), t625);
    let t626 = R::literal(0.12) * rod_omega;
    let t627 = t626 * cos_rod_phi;
    let t628 = (t626 * sin_rod_phi).add_product(t116, t627);
    let t629 = (t118 * t627).sub_product(t123, t628);
    let t630 = (t120 * t627).sub_product(t125, t628).sub_product(t128, t629) * t129;
    let t631 = (t629 * t126).sub_product(t128, t630);
    let t632 = (t628 * t121).sub_product(t123, t631).sub_product(t125, t630);
    let t633 = (-(t627 * t114)).add_product(t116, t632).add_product(t118, t631).add_product(t120,
        t630);
    let t634 = (t109 * t632).sub_product(t107, t633).sub_product(t111, t631).sub_product(t113,
        t630);
    let t635 = (-(t99 * t633)).add_product(t98, t634).add_product(t100, t632).add_product(t102,
        t631).add_product(t104, t630);
    let t636 = (t91 * t634).add_product(t89, t635).add_product(t93, t631).add_product(t95, t630);
    let t637 = (-(t80 * t635).add_product(t78, t636)).add_product(t82, t634).add_product(t84, t631)
        .add_product(t86, t630);
    let t638 = (t69 * t636).sub_product(t67, t637).add_product(t72, t631).sub_product(t75, t630);
    let t639 = (-(t57 * t637).add_product(t55, t638)).add_product(t58, t636).sub_product(t61, t631)
        .add_product(t63, t630);
    let t640 = (t50 * t638).add_product(t48, t639);
    let t641 = (t42 * t639).sub_product(t40, t640).add_product(t40, t638);
    let bobbin_v_y_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t630;
    let bobbin_v_x_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t631;
    let rod_omega_dot_by_rod_omega = (t34 * t633).sub_product(R::literal(4_166.666_666_666_667),
        t635).sub_product(t35, t632);
    let rod_v_y_dot_by_rod_omega = (R::literal(-5.0) * t632).sub_product(t33, t634);
    let rod_v_x_dot_by_rod_omega = (R::literal(-5.0) * t633).add_product(t32, t634);
    let cylinder_omega_dot_by_rod_omega = (-(t30 * t636).add_product(t29, t637)
        .add_product(R::literal(-2_777.777_777_777_778), t635)).add_product(t31, t634);
    let cylinder_v_y_dot_by_rod_omega = (t28 * t634)
        .add_product(R::literal(3.333_333_333_333_333_5), t636);
    let cylinder_v_x_dot_by_rod_omega = (-(t27 * t634))
        .add_product(R::literal(-3.333_333_333_333_333_5), t637);
    let plate_omega_dot_by_rod_omega = (t24 * t638).sub_product(t23, t639).sub_product(t23, t637)
        .sub_product(t24, t636).add_product(t25, t631).sub_product(t26, t630);
    let plate_v_y_dot_by_rod_omega = (R::literal(-0.833_333_333_333_333_4) * t636)
        .sub_product(R::literal(0.833_333_333_333_333_4), t638)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t630);
    let plate_v_x_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t637)
        .add_product(R::literal(-0.833_333_333_333_333_4), t639)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t631);
    let post_omega_dot_by_rod_omega = (-(t22 * t640).add_product(t21, t641).add_product(t21, t639))
        .add_product(t22, t638);
    let post_v_y_dot_by_rod_omega = (R::literal(1.25) * t638).add_product(R::literal(1.25), t640);
    let post_v_x_dot_by_rod_omega = (R::literal(1.25) * t639).add_product(R::literal(-1.25), t641);
    let t642 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t12 / between_squared));
    let t643 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t11 * t13 / between_squared));
    let t644 = (-t643).add_product(t128, t642) * t129;
    let t645 = (t642 * t126).add_product(t128, t644);
    let t646 = (-(t125 * t644)).add_product(t123, t645);
    let t647 = (-(t118 * t645)).add_product(t116, t646).add_product(t120, t644);
    let t648 = (t109 * t646).sub_product(t107, t647).add_product(t111, t645).sub_product(t113,
        t644);
    let t649 = (-(t99 * t647)).add_product(t98, t648).add_product(t100, t646).sub_product(t102,
        t645).add_product(t104, t644);
    let t650 = (-(t91 * t648).add_product(t89, t649)).add_product(t93, t645).sub_product(t95, t644);
    let t651 = (-(t80 * t649)).add_product(t78, t650).add_product(t82, t648).sub_product(t84, t645)
        .add_product(t86, t644);
    let t652 = (t69 * t650).add_product(t67, t651).add_product(t72, t645).add_product(t75, t644);
    let t653 = (-(t57 * t651)).add_product(t55, t652).sub_product(t58, t650).add_product(t61, t645)
        .add_product(t63, t644);
    let t654 = (t50 * t652).sub_product(t48, t653);
    let t655 = (t42 * t653).add_product(t40, t654).sub_product(t40, t652);
    let bobbin_v_y_dot_by_bobbin_v_x = t643.sub_product(R::literal(1.428_571_428_571_428_6), t644);
    let bobbin_v_x_dot_by_bobbin_v_x = t642.add_product(R::literal(1.428_571_428_571_428_6), t645);
    let rod_omega_dot_by_bobbin_v_x = (t34 * t647).sub_product(R::literal(4_166.666_666_666_667),
        t649).sub_product(t35, t646);
    let rod_v_y_dot_by_bobbin_v_x = (R::literal(-5.0) * t646).sub_product(t33, t648);
    let rod_v_x_dot_by_bobbin_v_x = (R::literal(-5.0) * t647).add_product(t32, t648);
    let cylinder_omega_dot_by_bobbin_v_x = (t30 * t650).sub_product(t29, t651)
        .sub_product(R::literal(-2_777.777_777_777_778), t649).add_product(t31, t648);
    let cylinder_v_y_dot_by_bobbin_v_x = (t28 * t648)
        .sub_product(R::literal(3.333_333_333_333_333_5), t650);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(t27 * t648))
        .add_product(R::literal(-3.333_333_333_333_333_5), t651);
    let plate_omega_dot_by_bobbin_v_x = (-(t24 * t652).add_product(t23, t653).add_product(t23,
        t651)).add_product(t24, t650).sub_product(t25, t645).sub_product(t26, t644);
    let plate_v_y_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t650)
        .add_product(R::literal(0.833_333_333_333_333_4), t652)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t644);
    let plate_v_x_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t651)
        .add_product(R::literal(0.833_333_333_333_333_4), t653))
        .add_product(R::literal(-0.833_333_333_333_333_4), t645);
    let post_omega_dot_by_bobbin_v_x = (t22 * t654).sub_product(t21, t655).sub_product(t21, t653)
        .sub_product(t22, t652);
    let post_v_y_dot_by_bobbin_v_x = (R::literal(-1.25) * t652).sub_product(R::literal(1.25), t654);
    let post_v_x_dot_by_bobbin_v_x = (R::literal(1.25) * t653).add_product(R::literal(-1.25), t655);
    let t656 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t14 / between_squared));
    let t657 = (-t656).add_product(t128, t643) * t129;
    let t658 = (t643 * t126).add_product(t128, t657);
    let t659 = (-(t125 * t657)).add_product(t123, t658);
    let t660 = (-(t118 * t658)).add_product(t116, t659).add_product(t120, t657);
    let t661 = (t109 * t659).sub_product(t107, t660).add_product(t111, t658).sub_product(t113,
        t657);
    let t662 = (-(t99 * t660)).add_product(t98, t661).add_product(t100, t659).sub_product(t102,
        t658).add_product(t104, t657);
    let t663 = (-(t91 * t661).add_product(t89, t662)).add_product(t93, t658).sub_product(t95, t657);
    let t664 = (-(t80 * t662)).add_product(t78, t663).add_product(t82, t661).sub_product(t84, t658)
        .add_product(t86, t657);
    let t665 = (t69 * t663).add_product(t67, t664).add_product(t72, t658).add_product(t75, t657);
    let t666 = (-(t57 * t664)).add_product(t55, t665).sub_product(t58, t663).add_product(t61, t658)
        .add_product(t63, t657);
    let t667 = (t50 * t665).sub_product(t48, t666);
    let t668 = (t42 * t666).add_product(t40, t667).sub_product(t40, t665);
    let bobbin_v_y_dot_by_bobbin_v_y = t656.sub_product(R::literal(1.428_571_428_571_428_6), t657);
    let bobbin_v_x_dot_by_bobbin_v_y = t643.add_product(R::literal(1.428_571_428_571_428_6), t658);
    let rod_omega_dot_by_bobbin_v_y = (t34 * t660).sub_product(R::literal(4_166.666_666_666_667),
        t662).sub_product(t35, t659);
    let rod_v_y_dot_by_bobbin_v_y = (R::literal(-5.0) * t659).sub_product(t33, t661);
    let rod_v_x_dot_by_bobbin_v_y = (R::literal(-5.0) * t660).add_product(t32, t661);
    let cylinder_omega_dot_by_bobbin_v_y = (t30 * t663).sub_product(t29, t664)
        .sub_product(R::literal(-2_777.777_777_777_778), t662).add_product(t31, t661);
    let cylinder_v_y_dot_by_bobbin_v_y = (t28 * t661)
        .sub_product(R::literal(3.333_333_333_333_333_5), t663);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(t27 * t661))
        .add_product(R::literal(-3.333_333_333_333_333_5), t664);
    let plate_omega_dot_by_bobbin_v_y = (-(t24 * t665).add_product(t23, t666).add_product(t23,
        t664)).add_product(t24, t663).sub_product(t25, t658).sub_product(t26, t657);
    let plate_v_y_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t663)
        .add_product(R::literal(0.833_333_333_333_333_4), t665)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t657);
    let plate_v_x_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t664)
        .add_product(R::literal(0.833_333_333_333_333_4), t666))
        .add_product(R::literal(-0.833_333_333_333_333_4), t658);
    let post_omega_dot_by_bobbin_v_y = (t22 * t667).sub_product(t21, t668).sub_product(t21, t666)
        .sub_product(t22, t665);
    let post_v_y_dot_by_bobbin_v_y = (R::literal(-1.25) * t665).sub_product(R::literal(1.25), t667);
    let post_v_x_dot_by_bobbin_v_y = (R::literal(1.25) * t666).add_product(R::literal(-1.25), t668);
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

/// `dy'/dp`, values in the order of its pattern. 1065 operations.
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
    let t10 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t12 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t13 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = t10 * R::literal(400.0);
    let t17 = t11 * R::literal(400.0);
    let t18 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t19 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t21 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t22 = slide * R::literal(2_777.777_777_777_778);
    let t23 = sin_cylinder_phi * R::literal(5.0);
    let t24 = cos_cylinder_phi * R::literal(5.0);
    let t25 = R::literal(250.0) * sin_rod_phi;
    let t26 = R::literal(250.0) * cos_rod_phi;
    let t27 = t12 * t1;
    let t28 = R::literal(1.25) + t27;
    let t29 = R::literal(1.0) / t28;
    let t30 = t13 * t1;
    let t31 = t30 * t29;
    let t32 = R::literal(1.25) - t27;
    let t33 = t32 * t29;
    let t34 = t13 * t0;
    let t35 = R::literal(1.25) + t34;
    let t36 = t31 * t30;
    let t37 = R::literal(1.0) / (t36 - t35);
    let t38 = (t12 * t0).add_product(t33, t30);
    let t39 = t38 * t37;
    let t40 = R::literal(1.25) - t34 + t36;
    let t41 = t40 * t37;
    let t42 = t14 * t3;
    let t43 = R::literal(1.0) / (-(t28 + R::literal(0.833_333_333_333_333_4) + t42))
        .add_product(t33, t32).sub_product(t39, t38);
    let t44 = t15 * t3;
    let t45 = (t30 + t44).add_product(t31, t32).sub_product(t41, t38);
    let t46 = t45 * t43;
    let t47 = R::literal(0.833_333_333_333_333_4) - t42;
    let t48 = t47 * t43;
    let t49 = t44 * t43;
    let t50 = t16 * t3;
    let t51 = R::literal(0.833_333_333_333_333_4) + t50;
    let t52 = t51 * t43;
    let t53 = t17 * t3;
    let t54 = t53 * t43;
    let t55 = t15 * t2;
    let t56 = R::literal(1.0) / (t36 - (t35 + R::literal(0.833_333_333_333_333_4) + t55))
        .sub_product(t41, t40).sub_product(t46, t45);
    let t57 = (t14 * t2).sub_product(t48, t45);
    let t58 = t57 * t56;
    let t59 = (R::literal(0.833_333_333_333_333_4) - t55).sub_product(t49, t45);
    let t60 = t59 * t56;
    let t61 = t16 * t2;
    let t62 = t61.add_product(t52, t45);
    let t63 = t62 * t56;
    let t64 = t17 * t2;
    let t65 = (R::literal(0.833_333_333_333_333_4) + t64).add_product(t54, t45);
    let t66 = t65 * t56;
    let t67 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t42
        + R::literal(3.333_333_333_333_333_5)).add_product(t20, t5).add_product(t48, t47)
        .add_product(t58, t57);
    let t68 = t44.add_product(t21, t5).sub_product(t49, t47).sub_product(t60, t57);
    let t69 = t68 * t67;
    let t70 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t71 = t70 * t67;
    let t72 = (-t18).add_product(t22, t5);
    let t73 = t72 * t67;
    let t74 = (t50 - R::literal(0.833_333_333_333_333_4)).sub_product(t52, t47).add_product(t63,
        t57);
    let t75 = t74 * t67;
    let t76 = (-t53).add_product(t54, t47).sub_product(t66, t57);
    let t77 = t76 * t67;
    let t78 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t55
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t4).add_product(t49, t44)
        .add_product(t60, t59)).add_product(t69, t68);
    let t79 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t71, t68);
    let t80 = t79 * t78;
    let t81 = t19.sub_product(t22, t4).add_product(t73, t68);
    let t82 = t81 * t78;
    let t83 = (-t61.add_product(t52, t44)).add_product(t63, t59).add_product(t75, t68);
    let t84 = t83 * t78;
    let t85 = (t64 - R::literal(0.833_333_333_333_333_4)).add_product(t54, t44).sub_product(t66,
        t59).add_product(t77, t68);
    let t86 = t85 * t78;
    let t87 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t71, t70)
        .sub_product(t80, t79);
    let t88 = t22.add_product(t73, t70).add_product(t82, t79);
    let t89 = t88 * t87;
    let t90 = t25 * t87;
    let t91 = t26 * t87;
    let t92 = (t75 * t70).add_product(t84, t79);
    let t93 = t92 * t87;
    let t94 = (t77 * t70).add_product(t86, t79);
    let t95 = t94 * t87;
    let t96 = R::literal(1.0) / (-(t18 * sin_cylinder_phi).add_product(t19, cos_cylinder_phi)
        .add_product(t22, slide).add_product(t23, sin_cylinder_phi).add_product(t24,
        cos_cylinder_phi)).add_product(t73, t72).sub_product(t82, t81).sub_product(t89, t88);
    let t97 = t23.add_product(t90, t88);
    let t98 = t97 * t96;
    let t99 = t24.add_product(t91, t88);
    let t100 = t99 * t96;
    let t101 = (t75 * t72).sub_product(t84, t81).sub_product(t93, t88);
    let t102 = t101 * t96;
    let t103 = (t77 * t72).sub_product(t86, t81).sub_product(t95, t88);
    let t104 = t103 * t96;
    let t105 = R::literal(1.0) / R::literal(5.0).add_product(t25, t6).add_product(t90, t25)
        .add_product(t98, t97);
    let t106 = (t26 * t6).add_product(t91, t25).add_product(t100, t97);
    let t107 = t106 * t105;
    let t108 = (t93 * t25).sub_product(t102, t97);
    let t109 = t108 * t105;
    let t110 = (t95 * t25).sub_product(t104, t97);
    let t111 = t110 * t105;
    let t112 = R::literal(1.0) / (-R::literal(5.0).add_product(t26, R::literal(0.06) * cos_rod_phi)
        .add_product(t91, t26).add_product(t100, t99)).add_product(t107, t106);
    let t113 = (-(t93 * t26)).add_product(t102, t99).add_product(t109, t106);
    let t114 = t113 * t112;
    let t115 = (-(t95 * t26)).add_product(t104, t99).add_product(t111, t106);
    let t116 = t115 * t112;
    let t117 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t16, t10)
        + R::literal(1.428_571_428_571_428_6)).add_product(t52, t51).add_product(t63, t62))
        .add_product(t75, t74).sub_product(t84, t83).sub_product(t93, t92).sub_product(t102, t101)
        .add_product(t109, t108).sub_product(t114, t113);
    let t118 = (t17 * t10).add_product(t54, t51).add_product(t66, t62).add_product(t77, t74)
        .sub_product(t86, t83).sub_product(t95, t92).sub_product(t104, t101).add_product(t111, t108)
        .sub_product(t116, t113);
    let t119 = t118 * t117;
    let t120 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t11)
        + R::literal(1.428_571_428_571_428_6)).add_product(t54, t53).add_product(t66, t65))
        .add_product(t77, t76).sub_product(t86, t85).sub_product(t95, t94).sub_product(t104, t103)
        .add_product(t111, t110).sub_product(t116, t115).sub_product(t119, t118);
    let t121 = slide - R::literal(0.116);
    let t122 = t121 * cos_cylinder_phi;
    let t123 = t121 * sin_cylinder_phi;
    let t124 = t121 * t9;
    let t125 = R::literal(3.333_333_333_333_333_5) * t122;
    let t126 = (-t125).add_product(t20, t124);
    let t127 = R::literal(3.333_333_333_333_333_5) * t123;
    let t128 = (-t127.add_product(t21, t124)).add_product(t69, t126);
    let t129 = (R::literal(-2_777.777_777_777_778) * t124).sub_product(t71, t126).sub_product(t80,
        t128);
    let t130 = (t19 * t123).sub_product(t18, t122).sub_product(t22, t124).sub_product(t23, t122)
        .add_product(t24, t123).add_product(t73, t126).sub_product(t82, t128).add_product(t89,
        t129);
    let t131 = R::literal(5.0) * t122;
    let t132 = t131.sub_product(t90, t129).sub_product(t98, t130);
    let t133 = R::literal(5.0) * t123;
    let t134 = t133.add_product(t91, t129).add_product(t100, t130).add_product(t107, t132);
    let t135 = (t75 * t126).sub_product(t84, t128).add_product(t93, t129).sub_product(t102, t130)
        .add_product(t109, t132).sub_product(t114, t134);
    let t136 = (t77 * t126).sub_product(t86, t128).add_product(t95, t129).sub_product(t104, t130)
        .add_product(t111, t132).sub_product(t116, t134).sub_product(t119, t135) * t120;
    let t137 = (t135 * t117).sub_product(t119, t136);
    let t138 = (t134 * t112).sub_product(t114, t137).sub_product(t116, t136);
    let t139 = (-(t132 * t105)).add_product(t107, t138).add_product(t109, t137).add_product(t111,
        t136);
    let t140 = (t130 * t96).sub_product(t98, t139).add_product(t100, t138).sub_product(t102, t137)
        .sub_product(t104, t136);
    let t141 = (t129 * t87).add_product(t89, t140).sub_product(t90, t139).add_product(t91, t138)
        .add_product(t93, t137).add_product(t95, t136);
    let t142 = (t128 * t78).sub_product(t80, t141).sub_product(t82, t140).sub_product(t84, t137)
        .sub_product(t86, t136);
    let t143 = (-(t126 * t67)).add_product(t69, t142).sub_product(t71, t141).add_product(t73, t140)
        .add_product(t75, t137).add_product(t77, t136);
    let t144 = (-(t60 * t142).add_product(t58, t143)).add_product(t63, t137).sub_product(t66, t136);
    let t145 = (-(t48 * t143).add_product(t46, t144).add_product(t49, t142).add_product(t52, t137))
        .add_product(t54, t136);
    let t146 = (t41 * t144).add_product(t39, t145);
    let t147 = (t33 * t145).sub_product(t31, t146).add_product(t31, t144);
    let bobbin_v_y_dot_by_spring_stiffness = R::literal(-1.428_571_428_571_428_6) * t136;
    let bobbin_v_x_dot_by_spring_stiffness = R::literal(-1.428_571_428_571_428_6) * t137;
    let rod_omega_dot_by_spring_stiffness = (t25 * t139)
        .sub_product(R::literal(4_166.666_666_666_667), t141).sub_product(t26, t138);
    let rod_v_y_dot_by_spring_stiffness = (-t133.add_product(t24, t140))
        .add_product(R::literal(-5.0), t138);
    let rod_v_x_dot_by_spring_stiffness = (-t131).add_product(t23, t140)
        .sub_product(R::literal(5.0), t139);
    let cylinder_omega_dot_by_spring_stiffness = (-(t124 * R::literal(2_777.777_777_777_778))
        .add_product(t20, t143)).add_product(t21, t142)
        .sub_product(R::literal(-2_777.777_777_777_778), t141).add_product(t22, t140);
    let cylinder_v_y_dot_by_spring_stiffness = t127
        .sub_product(R::literal(3.333_333_333_333_333_5), t142).add_product(t19, t140);
    let cylinder_v_x_dot_by_spring_stiffness = t125
        .sub_product(R::literal(3.333_333_333_333_333_5), t143).sub_product(t18, t140);
    let plate_omega_dot_by_spring_stiffness = (t15 * t144).sub_product(t14, t145).sub_product(t14,
        t143).add_product(t15, t142).add_product(t16, t137).sub_product(t17, t136);
    let plate_v_y_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t142)
        .add_product(R::literal(-0.833_333_333_333_333_4), t144)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t136);
    let plate_v_x_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t143)
        .add_product(R::literal(-0.833_333_333_333_333_4), t145)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t137);
    let post_omega_dot_by_spring_stiffness = (-(t13 * t146).add_product(t12, t147).add_product(t12,
        t145)).add_product(t13, t144);
    let post_v_y_dot_by_spring_stiffness = (R::literal(1.25) * t144).add_product(R::literal(1.25),
        t146);
    let post_v_x_dot_by_spring_stiffness = (R::literal(1.25) * t145).add_product(R::literal(-1.25),
        t147);
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let t148 = slide_rate * t9;
    let t149 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_cos_cylinder_phi;
    let t150 = (-t149).add_product(t20, t148);
    let t151 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_sin_cylinder_phi;
    let t152 = (-t151.add_product(t21, t148)).add_product(t69, t150);
    let t153 = (R::literal(-2_777.777_777_777_778) * t148).sub_product(t71, t150).sub_product(t80,
        t152);
    let t154 = (t19 * slide_rate_times_sin_cylinder_phi).sub_product(t18,
        slide_rate_times_cos_cylinder_phi).sub_product(t22, t148).sub_product(t23,
        slide_rate_times_cos_cylinder_phi).add_product(t24, slide_rate_times_sin_cylinder_phi)
        .add_product(t73, t150).sub_product(t82, t152).add_product(t89, t153);
    let t155 = R::literal(5.0) * slide_rate_times_cos_cylinder_phi;
    let t156 = t155.sub_product(t90, t153).sub_product(t98, t154);
    let t157 = R::literal(5.0) * slide_rate_times_sin_cylinder_phi;
    let t158 = t157.add_product(t91, t153).add_product(t100, t154).add_product(t107, t156);
    let t159 = (t75 * t150).sub_product(t84, t152).add_product(t93, t153).sub_product(t102, t154)
        .add_product(t109, t156).sub_product(t114, t158);
    let t160 = (t77 * t150).sub_product(t86, t152).add_product(t95, t153).sub_product(t104, t154)
        .add_product(t111, t156).sub_product(t116, t158).sub_product(t119, t159) * t120;
    let t161 = (t159 * t117).sub_product(t119, t160);
    let t162 = (t158 * t112).sub_product(t114, t161).sub_product(t116, t160);
    let t163 = (-(t156 * t105)).add_product(t107, t162).add_product(t109, t161).add_product(t111,
        t160);
    let t164 = (t154 * t96).sub_product(t98, t163).add_product(t100, t162).sub_product(t102, t161)
        .sub_product(t104, t160);
    let t165 = (t153 * t87).add_product(t89, t164).sub_product(t90, t163).add_product(t91, t162)
        .add_product(t93, t161).add_product(t95, t160);
    let t166 = (t152 * t78).sub_product(t80, t165).sub_product(t82, t164).sub_product(t84, t161)
        .sub_product(t86, t160);
    let t167 = (-(t150 * t67)).add_product(t69, t166).sub_product(t71, t165).add_product(t73, t164)
        .add_product(t75, t161).add_product(t77, t160);
    let t168 = (-(t60 * t166).add_product(t58, t167)).add_product(t63, t161).sub_product(t66, t160);
    let t169 = (-(t48 * t167).add_product(t46, t168).add_product(t49, t166).add_product(t52, t161))
        .add_product(t54, t160);
    let t170 = (t41 * t168).add_product(t39, t169);
    let t171 = (t33 * t169).sub_product(t31, t170).add_product(t31, t168);
    let bobbin_v_y_dot_by_spring_damping = R::literal(-1.428_571_428_571_428_6) * t160;
    let bobbin_v_x_dot_by_spring_damping = R::literal(-1.428_571_428_571_428_6) * t161;
    let rod_omega_dot_by_spring_damping = (t25 * t163)
        .sub_product(R::literal(4_166.666_666_666_667), t165).sub_product(t26, t162);
    let rod_v_y_dot_by_spring_damping = (-t157.add_product(t24, t164))
        .add_product(R::literal(-5.0), t162);
    let rod_v_x_dot_by_spring_damping = (-t155).add_product(t23, t164).sub_product(R::literal(5.0),
        t163);
    let cylinder_omega_dot_by_spring_damping = (-(t148 * R::literal(2_777.777_777_777_778))
        .add_product(t20, t167)).add_product(t21, t166)
        .sub_product(R::literal(-2_777.777_777_777_778), t165).add_product(t22, t164);
    let cylinder_v_y_dot_by_spring_damping = t151.sub_product(R::literal(3.333_333_333_333_333_5),
        t166).add_product(t19, t164);
    let cylinder_v_x_dot_by_spring_damping = t149.sub_product(R::literal(3.333_333_333_333_333_5),
        t167).sub_product(t18, t164);
    let plate_omega_dot_by_spring_damping = (t15 * t168).sub_product(t14, t169).sub_product(t14,
        t167).add_product(t15, t166).add_product(t16, t161).sub_product(t17, t160);
    let plate_v_y_dot_by_spring_damping = (R::literal(0.833_333_333_333_333_4) * t166)
        .add_product(R::literal(-0.833_333_333_333_333_4), t168)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t160);
    let plate_v_x_dot_by_spring_damping = (R::literal(0.833_333_333_333_333_4) * t167)
        .add_product(R::literal(-0.833_333_333_333_333_4), t169)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t161);
    let post_omega_dot_by_spring_damping = (-(t13 * t170).add_product(t12, t171).add_product(t12,
        t169)).add_product(t13, t168);
    let post_v_y_dot_by_spring_damping = (R::literal(1.25) * t168).add_product(R::literal(1.25),
        t170);
    let post_v_x_dot_by_spring_damping = (R::literal(1.25) * t169).add_product(R::literal(-1.25),
        t171);
    let t172 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_gap * t7 / between));
    let t173 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_gap * t8 / between));
    let t174 = (-t173).add_product(t119, t172) * t120;
    let t175 = (t172 * t117).add_product(t119, t174);
    let t176 = (-(t116 * t174)).add_product(t114, t175);
    let t177 = (-(t109 * t175)).add_product(t107, t176).add_product(t111, t174);
    let t178 = (t100 * t176).sub_product(t98, t177).add_product(t102, t175).sub_product(t104, t174);
    let t179 = (-(t90 * t177)).add_product(t89, t178).add_product(t91, t176).sub_product(t93, t175)
        .add_product(t95, t174);
    let t180 = (-(t82 * t178).add_product(t80, t179)).add_product(t84, t175).sub_product(t86, t174);
    let t181 = (-(t71 * t179)).add_product(t69, t180).add_product(t73, t178).sub_product(t75, t175)
        .add_product(t77, t174);
    let t182 = (t60 * t180).add_product(t58, t181).add_product(t63, t175).add_product(t66, t174);
    let t183 = (-(t48 * t181)).add_product(t46, t182).sub_product(t49, t180).add_product(t52, t175)
        .add_product(t54, t174);
    let t184 = (t41 * t182).sub_product(t39, t183);
    let t185 = (t33 * t183).add_product(t31, t184).sub_product(t31, t182);
    let bobbin_v_y_dot_by_contact_stiffness = t173.sub_product(R::literal(1.428_571_428_571_428_6),
        t174);
    let bobbin_v_x_dot_by_contact_stiffness = t172.add_product(R::literal(1.428_571_428_571_428_6),
        t175);
    let rod_omega_dot_by_contact_stiffness = (t25 * t177)
        .sub_product(R::literal(4_166.666_666_666_667), t179).sub_product(t26, t176);
    let rod_v_y_dot_by_contact_stiffness = (R::literal(-5.0) * t176).sub_product(t24, t178);
    let rod_v_x_dot_by_contact_stiffness = (R::literal(-5.0) * t177).add_product(t23, t178);
    let cylinder_omega_dot_by_contact_stiffness = (t21 * t180).sub_product(t20, t181)
        .sub_product(R::literal(-2_777.777_777_777_778), t179).add_product(t22, t178);
    let cylinder_v_y_dot_by_contact_stiffness = (t19 * t178)
        .sub_product(R::literal(3.333_333_333_333_333_5), t180);
    let cylinder_v_x_dot_by_contact_stiffness = (-(t18 * t178))
        .add_product(R::literal(-3.333_333_333_333_333_5), t181);
    let plate_omega_dot_by_contact_stiffness = (-(t15 * t182).add_product(t14, t183)
        .add_product(t14, t181)).add_product(t15, t180).sub_product(t16, t175).sub_product(t17,
        t174);
    let plate_v_y_dot_by_contact_stiffness = (R::literal(0.833_333_333_333_333_4) * t180)
        .add_product(R::literal(0.833_333_333_333_333_4), t182)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t174);
    let plate_v_x_dot_by_contact_stiffness = (-(R::literal(-0.833_333_333_333_333_4) * t181)
        .add_product(R::literal(0.833_333_333_333_333_4), t183))
        .add_product(R::literal(-0.833_333_333_333_333_4), t175);
    let post_omega_dot_by_contact_stiffness = (t13 * t184).sub_product(t12, t185).sub_product(t12,
        t183).sub_product(t13, t182);
    let post_v_y_dot_by_contact_stiffness = (R::literal(-1.25) * t182)
        .sub_product(R::literal(1.25), t184);
    let post_v_x_dot_by_contact_stiffness = (R::literal(1.25) * t183)
        .add_product(R::literal(-1.25), t185);
    let t186 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_rate * t7 / between));
    let t187 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_rate * t8 / between));
    let t188 = (-t187).add_product(t119, t186) * t120;
    let t189 = (t186 * t117).add_product(t119, t188);
    let t190 = (-(t116 * t188)).add_product(t114, t189);
    let t191 = (-(t109 * t189)).add_product(t107, t190).add_product(t111, t188);
    let t192 = (t100 * t190).sub_product(t98, t191).add_product(t102, t189).sub_product(t104, t188);
    let t193 = (-(t90 * t191)).add_product(t89, t192).add_product(t91, t190).sub_product(t93, t189)
        .add_product(t95, t188);
    let t194 = (-(t82 * t192).add_product(t80, t193)).add_product(t84, t189).sub_product(t86, t188);
    let t195 = (-(t71 * t193)).add_product(t69, t194).add_product(t73, t192).sub_product(t75, t189)
        .add_product(t77, t188);
    let t196 = (t60 * t194).add_product(t58, t195).add_product(t63, t189).add_product(t66, t188);
    let t197 = (-(t48 * t195)).add_product(t46, t196).sub_product(t49, t194).add_product(t52, t189)
        .add_product(t54, t188);
    let t198 = (t41 * t196).sub_product(t39, t197);
    let t199 = (t33 * t197).add_product(t31, t198).sub_product(t31, t196);
    let bobbin_v_y_dot_by_contact_damping = t187.sub_product(R::literal(1.428_571_428_571_428_6),
        t188);
    let bobbin_v_x_dot_by_contact_damping = t186.add_product(R::literal(1.428_571_428_571_428_6),
        t189);
    let rod_omega_dot_by_contact_damping = (t25 * t191)
        .sub_product(R::literal(4_166.666_666_666_667), t193).sub_product(t26, t190);
    let rod_v_y_dot_by_contact_damping = (R::literal(-5.0) * t190).sub_product(t24, t192);
    let rod_v_x_dot_by_contact_damping = (R::literal(-5.0) * t191).add_product(t23, t192);
    let cylinder_omega_dot_by_contact_damping = (t21 * t194).sub_product(t20, t195)
        .sub_product(R::literal(-2_777.777_777_777_778), t193).add_product(t22, t192);
    let cylinder_v_y_dot_by_contact_damping = (t19 * t192)
        .sub_product(R::literal(3.333_333_333_333_333_5), t194);
    let cylinder_v_x_dot_by_contact_damping = (-(t18 * t192))
        .add_product(R::literal(-3.333_333_333_333_333_5), t195);
    let plate_omega_dot_by_contact_damping = (-(t15 * t196).add_product(t14, t197).add_product(t14,
        t195)).add_product(t15, t194).sub_product(t16, t189).sub_product(t17, t188);
    let plate_v_y_dot_by_contact_damping = (R::literal(0.833_333_333_333_333_4) * t194)
        .add_product(R::literal(0.833_333_333_333_333_4), t196)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t188);
    let plate_v_x_dot_by_contact_damping = (-(R::literal(-0.833_333_333_333_333_4) * t195)
        .add_product(R::literal(0.833_333_333_333_333_4), t197))
        .add_product(R::literal(-0.833_333_333_333_333_4), t189);
    let post_omega_dot_by_contact_damping = (t13 * t198).sub_product(t12, t199).sub_product(t12,
        t197).sub_product(t13, t196);
    let post_v_y_dot_by_contact_damping = (R::literal(-1.25) * t196).sub_product(R::literal(1.25),
        t198);
    let post_v_x_dot_by_contact_damping = (R::literal(1.25) * t197).add_product(R::literal(-1.25),
        t199);
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

/// Wanted outputs. 50 operations.
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
    let stop_push = (R::literal(-1_000_000.0) * stop_gap).sub_product(R::literal(1500.0),
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
        strut_push: (p.spring_stiffness * (R::literal(0.116) - slide))
            .sub_product(p.spring_damping, slide_rate),
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 819 operations.
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
    let t11 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t12 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t13 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t14 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = t11 * R::literal(400.0);
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
    let t71 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t72 = t71 * t68;
    let t73 = (-t19).add_product(t23, t5);
    let t74 = t73 * t68;
    let t75 = (t51 - R::literal(0.833_333_333_333_333_4)).sub_product(t53, t48).add_product(t64,
        t58);
    let t76 = t75 * t68;
    let t77 = (-t54).add_product(t55, t48).sub_product(t67, t58);
    let t78 = t77 * t68;
    let t79 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t56
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t50, t45)
        .add_product(t61, t60)).add_product(t70, t69);
    let t80 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t72, t69);
    let t81 = t80 * t79;
    let t82 = t20.sub_product(t23, t4).add_product(t74, t69);
    let t83 = t82 * t79;
    let t84 = (-t62.add_product(t53, t45)).add_product(t64, t60).add_product(t76, t69);
    let t85 = t84 * t79;
    let t86 = (t65 - R::literal(0.833_333_333_333_333_4)).add_product(t55, t45).sub_product(t67,
        t60).add_product(t78, t69);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t72, t71)
        .sub_product(t81, t80);
    let t89 = t23.add_product(t74, t71).add_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t26 * t88;
    let t92 = t27 * t88;
    let t93 = (t76 * t71).add_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t71).add_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t74, t73).sub_product(t83, t82).sub_product(t90, t89);
    let t98 = t24.add_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = t25.add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (t76 * t73).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (t78 * t73).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t91, t26)
        .add_product(t99, t98);
    let t107 = (t27 * t6).add_product(t92, t26).add_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (t94 * t26).sub_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (t96 * t26).sub_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t92, t27).add_product(t101, t100)).add_product(t108, t107);
    let t114 = (-(t94 * t27)).add_product(t103, t100).add_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (-(t96 * t27)).add_product(t105, t100).add_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t11)
        + R::literal(1.428_571_428_571_428_6)).add_product(t53, t52).add_product(t64, t63))
        .add_product(t76, t75).sub_product(t85, t84).sub_product(t94, t93).sub_product(t103, t102)
        .add_product(t110, t109).sub_product(t115, t114);
    let t119 = (t18 * t11).add_product(t55, t52).add_product(t67, t63).add_product(t78, t75)
        .sub_product(t87, t84).sub_product(t96, t93).sub_product(t105, t102).add_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::literal(1_000_000.0) * stop_gap * t7;
    let t122 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), (-t121)
        .add_product(R::literal(-1500.0) * stop_rate, t7));
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
    let t141 = t13 * t122;
    let t142 = t137 + t141;
    let t143 = t14 * t122;
    let t144 = t32 * t142;
    let t145 = R::literal(9.81) - t138 + t143 - t144;
    let t146 = (t137.add_product(t139, cos_plate_phi) + t141).add_product(t34, t142)
        .add_product(t40, t145);
    let t147 = (t143 - (t138.add_product(t139, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) - t144).sub_product(t42, t145).add_product(t47, t146);
    let t148 = R::literal(3.333_333_333_333_333_5) * t125;
    let t149 = (-t148.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))).add_product(t21, t131)
        .add_product(t49, t146).sub_product(t59, t147);
    let t150 = R::literal(3.333_333_333_333_333_5) * t129;
    let t151 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t150)
        .add_product(t22, t131)).add_product(t50, t146).sub_product(t61, t147).add_product(t70,
        t149);
    let t152 = (R::literal(-2_777.777_777_777_778) * t131).sub_product(t72, t149).sub_product(t81,
        t151);
    let t153 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t125)
        .add_product(t20, t129).sub_product(t23, t131).sub_product(t24, t125).add_product(t25, t133)
        .add_product(t74, t149).sub_product(t83, t151);
    let t154 = t153.add_product(t90, t152);
    let t155 = R::literal(5.0) * t125;
    let t156 = t155.add_product(t140, cos_rod_phi).sub_product(t91, t152).sub_product(t99, t154);
    let t157 = R::literal(5.0) * t133;
    let t158 = t157.add_product(t140, sin_rod_phi).add_product(t92, t152).add_product(t101, t154)
        .add_product(t108, t156);
    let t159 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t134 + contact_damping_times_contact_rate * t8
        / between));
    let t160 = (-t159).add_product(t12, plate_omega_squared).add_product(t53, t146)
        .add_product(t64, t147).add_product(t76, t149).sub_product(t85, t151).add_product(t94, t152)
        .sub_product(t103, t154).add_product(t110, t156).sub_product(t115, t158);
    let t161 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_damping_times_contact_rate * t9 / between))
        - t135);
    let t162 = (R::literal(-9.81).add_product(t11, plate_omega_squared) - t161).sub_product(t55,
        t146).sub_product(t67, t147).add_product(t78, t149).sub_product(t87, t151).add_product(t96,
        t152).sub_product(t105, t154).add_product(t112, t156).sub_product(t117, t158)
        .sub_product(t120, t160) * (R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4)
        .add_product(t18, t12) + R::literal(1.428_571_428_571_428_6)).add_product(t55, t54)
        .add_product(t67, t66)).add_product(t78, t77).sub_product(t87, t86).sub_product(t96, t95)
        .sub_product(t105, t104).add_product(t112, t111).sub_product(t117, t116).sub_product(t120,
        t119));
    let t163 = (t160 * t118).sub_product(t120, t162);
    let t164 = (t158 * t113).sub_product(t115, t163).sub_product(t117, t162);
    let t165 = (-(t156 * t106)).add_product(t108, t164).add_product(t110, t163).add_product(t112,
        t162);
    let t166 = (t154 * t97).sub_product(t99, t165).add_product(t101, t164).sub_product(t103, t163)
        .sub_product(t105, t162);
    let t167 = (t152 * t88).add_product(t90, t166).sub_product(t91, t165).add_product(t92, t164)
        .add_product(t94, t163).add_product(t96, t162);
    let t168 = (t151 * t79).sub_product(t81, t167).sub_product(t83, t166).sub_product(t85, t163)
        .sub_product(t87, t162);
    let t169 = (-(t149 * t68)).add_product(t70, t168).sub_product(t72, t167).add_product(t74, t166)
        .add_product(t76, t163).add_product(t78, t162);
    let t170 = (t147 * t57).sub_product(t59, t169).sub_product(t61, t168).add_product(t64, t163)
        .sub_product(t67, t162);
    let t171 = (-(t146 * t44).add_product(t47, t170).add_product(t49, t169).add_product(t50, t168)
        .add_product(t53, t163)).add_product(t55, t162);
    let t172 = (t145 * t38).sub_product(t40, t171).sub_product(t42, t170);
    let t173 = (t142 * t30).add_product(t32, t172).add_product(t34, t171).add_product(t32, t170);
    let bobbin_v_y_dot = t161.sub_product(R::literal(1.428_571_428_571_428_6), t162);
    let bobbin_v_x_dot = t159.sub_product(R::literal(1.428_571_428_571_428_6), t163);
    let rod_omega_dot = (t26 * t165).sub_product(R::literal(4_166.666_666_666_667), t167)
        .sub_product(t27, t164);
    let rod_v_x_dot = (-t155).add_product(t24, t166).sub_product(R::literal(5.0), t165);
    let cylinder_omega_dot = (-(t131 * R::literal(2_777.777_777_777_778)).add_product(t21, t169))
        .add_product(t22, t168).sub_product(R::literal(-2_777.777_777_777_778), t167)
        .add_product(t23, t166);
    let cylinder_v_y_dot = t150.sub_product(R::literal(3.333_333_333_333_333_5), t168)
        .add_product(t20, t166);
    let cylinder_v_x_dot = t148.sub_product(R::literal(3.333_333_333_333_333_5), t169)
        .sub_product(t19, t166);
    let plate_omega_dot = (t16 * t170).sub_product(t15, t171).sub_product(t15, t169)
        .add_product(t16, t168).add_product(t17, t163).sub_product(t18, t162);
    let post_omega_dot = (t122 * R::literal(370.370_370_370_370_3)).sub_product(t13, t173)
        .add_product(t14, t172).sub_product(t13, t171).add_product(t14, t170);
    let t174 = (R::literal(7.848) * post_v_y).add_product(R::select_less(stop_closed,
        R::literal(0.5), R::literal(0.0), t121), post_omega).add_product(R::literal(11.772),
        plate_v_y).sub_product(t124, cylinder_v_x).add_product(t127, cylinder_v_y)
        .add_product(t130, cylinder_omega).add_product(t124, rod_v_x).add_product(t132, rod_v_y)
        .add_product(R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t134),
        bobbin_v_x).add_product(t135, bobbin_v_y).sub_product(R::literal(0.8) * post_v_x,
        (R::literal(-1.25) * t171).add_product(R::literal(1.25), t173)).sub_product(R::literal(0.8)
        * post_v_y, R::literal(9.81).add_product(R::literal(1.25), t172)
        .add_product(R::literal(-1.25), t170)).add_product(R::literal(0.0027) * post_omega,
        post_omega_dot);
    let t175 = t174.sub_product(R::literal(1.2) * plate_v_x, (R::literal(-0.833_333_333_333_333_4)
        * t169).add_product(R::literal(0.833_333_333_333_333_4), t171)
        .add_product(R::literal(-0.833_333_333_333_333_4), t163)).sub_product(R::literal(1.2)
        * plate_v_y, R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t170)
        .add_product(R::literal(-0.833_333_333_333_333_4), t168)
        .add_product(R::literal(-0.833_333_333_333_333_4), t162)).add_product(R::literal(0.0025)
        * plate_omega, plate_omega_dot).add_product(R::literal(0.3) * cylinder_v_x,
        cylinder_v_x_dot).add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
        .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
        .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot).sub_product(R::literal(0.2) * rod_v_y,
        t157.add_product(t25, t166).add_product(R::literal(5.0), t164));
    let t176 = (p.spring_damping * cylinder_omega * slide_rate * t10).add_product(p.spring_damping
        * rod_v_x * slide_rate, cos_cylinder_phi).add_product(p.spring_damping * rod_v_y
        * slide_rate, sin_cylinder_phi) + R::select_less(contact_closed, R::literal(0.5),
        R::literal(0.0), p.contact_damping * bobbin_v_x * contact_rate * t8 / between
        + p.contact_damping * bobbin_v_y * contact_rate * t9 / between)
        + R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(1500.0)
        * (stop_rate * stop_rate));
    PowerBalance {
        stored_rate: t175.add_product(R::literal(0.00024) * rod_omega, rod_omega_dot)
            .add_product(R::literal(0.7) * bobbin_v_x, bobbin_v_x_dot).add_product(R::literal(0.7)
            * bobbin_v_y, bobbin_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: t176.sub_product(p.spring_damping * cylinder_v_x * slide_rate, cos_cylinder_phi)
            .sub_product(p.spring_damping * cylinder_v_y * slide_rate, sin_cylinder_phi),
    }
}

/// What passes zero where events happen, one for each event. 27 operations.
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
    let stop_push = (R::literal(-1_000_000.0) * stop_gap).sub_product(R::literal(1500.0),
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
    let t11 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t12 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t13 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t14 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = t11 * R::literal(400.0);
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
    let t71 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t72 = t71 * t68;
    let t73 = (-t19).add_product(t23, t5);
    let t74 = t73 * t68;
    let t75 = (t51 - R::literal(0.833_333_333_333_333_4)).sub_product(t53, t48).add_product(t64,
        t58);
    let t76 = t75 * t68;
    let t77 = (-t54).add_product(t55, t48).sub_product(t67, t58);
    let t78 = t77 * t68;
    let t79 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t56
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t50, t45)
        .add_product(t61, t60)).add_product(t70, t69);
    let t80 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t72, t69);
    let t81 = t80 * t79;
    let t82 = t20.sub_product(t23, t4).add_product(t74, t69);
    let t83 = t82 * t79;
    let t84 = (-t62.add_product(t53, t45)).add_product(t64, t60).add_product(t76, t69);
    let t85 = t84 * t79;
    let t86 = (t65 - R::literal(0.833_333_333_333_333_4)).add_product(t55, t45).sub_product(t67,
        t60).add_product(t78, t69);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t72, t71)
        .sub_product(t81, t80);
    let t89 = t23.add_product(t74, t71).add_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t26 * t88;
    let t92 = t27 * t88;
    let t93 = (t76 * t71).add_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t71).add_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t74, t73).sub_product(t83, t82).sub_product(t90, t89);
    let t98 = t24.add_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = t25.add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (t76 * t73).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (t78 * t73).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t91, t26)
        .add_product(t99, t98);
    let t107 = (t27 * t6).add_product(t92, t26).add_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (t94 * t26).sub_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (t96 * t26).sub_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t92, t27).add_product(t101, t100)).add_product(t108, t107);
    let t114 = (-(t94 * t27)).add_product(t103, t100).add_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (-(t96 * t27)).add_product(t105, t100).add_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t11)
        + R::literal(1.428_571_428_571_428_6)).add_product(t53, t52).add_product(t64, t63))
        .add_product(t76, t75).sub_product(t85, t84).sub_product(t94, t93).sub_product(t103, t102)
        .add_product(t110, t109).sub_product(t115, t114);
    let t119 = (t18 * t11).add_product(t55, t52).add_product(t67, t63).add_product(t78, t75)
        .sub_product(t87, t84).sub_product(t96, t93).sub_product(t105, t102).add_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (R::literal(-1_000_000.0) * stop_gap * t7).sub_product(R::literal(1500.0) * stop_rate, t7));
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
    let t136 = t13 * t121;
    let t137 = t132 + t136;
    let t138 = t14 * t121;
    let t139 = t32 * t137;
    let t140 = R::literal(9.81) - t133 + t138 - t139;
    let t141 = (t132.add_product(t134, cos_plate_phi) + t136).add_product(t34, t137)
        .add_product(t40, t140);
    let t142 = (t138 - (t133.add_product(t134, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) - t139).sub_product(t42, t140).add_product(t47, t141);
    let t143 = (-(R::literal(0.06) * (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .add_product(R::literal(3.333_333_333_333_333_5), t123)).add_product(t21, t127)
        .add_product(t49, t141).sub_product(t59, t142);
    let t144 = (-R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi))
        .add_product(R::literal(3.333_333_333_333_333_5), t126).add_product(t22, t127))
        .add_product(t50, t141).sub_product(t61, t142).add_product(t70, t143);
    let t145 = (R::literal(-2_777.777_777_777_778) * t127).sub_product(t72, t143).sub_product(t81,
        t144);
    let t146 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t123)
        .add_product(t20, t126).sub_product(t23, t127).sub_product(t24, t123).add_product(t25, t128)
        .add_product(t74, t143).sub_product(t83, t144);
    let t147 = t146.add_product(t90, t145);
    let t148 = (t135 * cos_rod_phi).add_product(R::literal(5.0), t123).sub_product(t91, t145)
        .sub_product(t99, t147);
    let t149 = (t135 * sin_rod_phi).add_product(R::literal(5.0), t128).add_product(t92, t145)
        .add_product(t101, t147).add_product(t108, t148);
    let t150 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(contact_stiffness_times_contact_gap * t8 / between
        + t129 / between));
    let t151 = (-t150).add_product(t12, plate_omega_squared).add_product(t53, t141)
        .add_product(t64, t142).add_product(t76, t143).sub_product(t85, t144).add_product(t94, t145)
        .sub_product(t103, t147).add_product(t110, t148).sub_product(t115, t149);
    let t152 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t130 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t9 / between)));
    let t153 = (R::literal(-9.81).add_product(t11, plate_omega_squared) - t152).sub_product(t55,
        t141).sub_product(t67, t142).add_product(t78, t143).sub_product(t87, t144).add_product(t96,
        t145).sub_product(t105, t147).add_product(t112, t148).sub_product(t117, t149)
        .sub_product(t120, t151) * (R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4)
        .add_product(t18, t12) + R::literal(1.428_571_428_571_428_6)).add_product(t55, t54)
        .add_product(t67, t66)).add_product(t78, t77).sub_product(t87, t86).sub_product(t96, t95)
        .sub_product(t105, t104).add_product(t112, t111).sub_product(t117, t116).sub_product(t120,
        t119));
    let t154 = (t151 * t118).sub_product(t120, t153);
    let t155 = (t149 * t113).sub_product(t115, t154).sub_product(t117, t153);
    let t156 = (-(t148 * t106)).add_product(t108, t155).add_product(t110, t154).add_product(t112,
        t153);
    let t157 = (t147 * t97).sub_product(t99, t156).add_product(t101, t155).sub_product(t103, t154)
        .sub_product(t105, t153);
    let t158 = (t145 * t88).add_product(t90, t157).sub_product(t91, t156).add_product(t92, t155)
        .add_product(t94, t154).add_product(t96, t153);
    let t159 = (t144 * t79).sub_product(t81, t158).sub_product(t83, t157).sub_product(t85, t154)
        .sub_product(t87, t153);
    let t160 = (-(t143 * t68)).add_product(t70, t159).sub_product(t72, t158).add_product(t74, t157)
        .add_product(t76, t154).add_product(t78, t153);
    let t161 = (t142 * t57).sub_product(t59, t160).sub_product(t61, t159).add_product(t64, t154)
        .sub_product(t67, t153);
    let t162 = (-(t141 * t44).add_product(t47, t161).add_product(t49, t160).add_product(t50, t159)
        .add_product(t53, t154)).add_product(t55, t153);
    let t163 = (t140 * t38).sub_product(t40, t162).sub_product(t42, t161);
    let bobbin_v_y_dot = t152.sub_product(R::literal(1.428_571_428_571_428_6), t153);
    let bobbin_v_x_dot = t150.sub_product(R::literal(1.428_571_428_571_428_6), t154);
    let post_omega_dot = (t121 * R::literal(370.370_370_370_370_3)).sub_product(t13, (t137 * t30)
        .add_product(t32, t163).add_product(t34, t162).add_product(t32, t161)).add_product(t14,
        t163).sub_product(t13, t162).add_product(t14, t161);
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
        .sub_product((R::literal(214.5) * cos_post_phi).add_product(R::literal(66.0),
        sin_post_phi), post_omega_dot);
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
        R::literal(-1.0), (R::literal(-0.01) * sin_plate_phi).sub_product(R::literal(0.1),
        cos_plate_phi), R::literal(1.0), R::literal(-1.0), (R::literal(0.01)
        * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi), R::literal(1.0)]
}
