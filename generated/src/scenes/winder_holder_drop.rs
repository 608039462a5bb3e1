// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   044e0f4a1f2bab23afeb6e3d262a47321342ed9c5c3cc52995c00ca78c21b7a4  scenes/winder_holder_drop.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//   aa0e8a999f462eeff001756527f878c9e91be49559e9f536983ca628c62c89a6  units/spring_damper.toml
//   a7990db08476f2615903f9423a5b29997fa55f4feedd941579cf9c2628578a55  units/one_sided_contact.toml
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
// Operations: initial_state 1, rate 722, forcing 78, rate_jacobian 348, parameter_jacobian 57,
//     outputs 52, energy 78, power_balance 109, guards 31, guard_rates 59, constraint_values 49,
//     constraint_rates 63, constraint_matrix 30, prepare 1, prepared_rate 722,
//     prepared_rate_jacobian 347, motion 747.

use ::machinist_contract::{Energy, PowerBalance, Real, implicit::{Step, substitute}};

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
    "contact.touches": Rising, when [(28, 0.0)], sets [28], "contact begins";
    "contact.opens": Falling, when [(28, 1.0)], sets [28], "the contact would pull";
    "stop.touches": Rising, when [(29, 0.0)], sets [29], "contact begins";
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

/// What several functions need of the motion; `motion` says what each is.
#[allow(missing_docs, reason = "`motion` says what each is")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    pub factors: [R; 76],
    pub cos_post_phi: R,
    pub sin_post_phi: R,
    pub cos_plate_phi: R,
    pub sin_plate_phi: R,
    pub cos_cylinder_phi: R,
    pub sin_cylinder_phi: R,
    pub cos_rod_phi: R,
    pub sin_rod_phi: R,
    pub stop_gap: R,
    pub t7: R,
    pub t9: R,
    pub t11: R,
    pub between: R,
    pub slide: R,
    pub contact_rate: R,
    pub t12: R,
    pub slide_rate: R,
    pub t13: R,
    pub t14: R,
    pub t153: R,
    pub t155: R,
    pub t158: R,
    pub t161: R,
    pub t162: R,
    pub t163: R,
    pub t164: R,
    pub t165: R,
    pub t167: R,
    pub t168: R,
    pub t170: R,
    pub t171: R,
    pub t173: R,
    pub t174: R,
    pub t196: R,
    pub t197: R,
    pub t199: R,
    pub t200: R,
    pub t201: R,
    pub t202: R,
    pub t203: R,
    pub t205: R,
    pub t206: R,
    pub t209: R,
    pub t210: R,
    pub t212: R,
    pub t213: R,
    pub t215: R,
    pub t216: R,
    pub t217: R,
    pub t219: R,
    pub t220: R,
    pub bobbin_v_y_dot: R,
    pub bobbin_v_x_dot: R,
    pub rod_omega_dot: R,
    pub t221: R,
    pub rod_v_x_dot: R,
    pub cylinder_omega_dot: R,
    pub cylinder_v_y_dot: R,
    pub cylinder_v_x_dot: R,
    pub plate_omega_dot: R,
    pub t222: R,
    pub t223: R,
    pub t224: R,
    pub post_omega_dot: R,
    pub t225: R,
    pub t226: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions
/// need. 747 operations.
#[must_use]
pub fn motion<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        _c: &Constants<R>) -> Motion<R> {
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
    let t9 = t8 * t8;
    let t10 = bobbin_y - R::literal(0.058);
    let t11 = t10 * t10;
    let between = (t9 + t11).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t10) / between;
    let t12 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t12)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t13 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t14 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t15 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t16 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t17 = -t16;
    let t18 = R::literal(24.0) * sin_plate_phi;
    let t19 = R::literal(24.0) * cos_plate_phi;
    let t20 = -t19;
    let t21 = t13 * R::literal(400.0);
    let t22 = -t21;
    let t23 = t14 * R::literal(400.0);
    let t24 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t25 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t26 = -t25;
    let t27 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t28 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t29 = -t28;
    let t30 = slide * R::literal(2_777.777_777_777_778);
    let t31 = -t30;
    let t32 = sin_cylinder_phi * R::literal(5.0);
    let t33 = -t32;
    let t34 = cos_cylinder_phi * R::literal(5.0);
    let t35 = R::literal(250.0) * sin_rod_phi;
    let t36 = -t35;
    let t37 = R::literal(250.0) * cos_rod_phi;
    let t38 = t15 * t1;
    let t39 = R::literal(1.25) + t38;
    let t40 = R::literal(1.0) / t39;
    let t41 = -t40;
    let t42 = t16 * t1;
    let t43 = t42 * t40;
    let t44 = -t43;
    let t45 = R::literal(1.25) - t38;
    let t46 = t45 * t40;
    let t47 = -t46;
    let t48 = t16 * t0;
    let t49 = R::literal(1.25) + t48;
    let t50 = t43 * t42;
    let t51 = R::literal(1.0) / (t50 - t49);
    let t52 = (t15 * t0).add_product(t46, t42);
    let t53 = t52 * t51;
    let t54 = R::literal(1.25) - t48 + t50;
    let t55 = t54 * t51;
    let t56 = t18 * t3;
    let t57 = R::literal(1.0) / (-(t39 + R::literal(0.833_333_333_333_333_4) + t56))
        .add_product(t46, t45).sub_product(t53, t52);
    let t58 = t19 * t3;
    let t59 = (t42 + t58).add_product(t43, t45).sub_product(t55, t52);
    let t60 = t59 * t57;
    let t61 = R::literal(0.833_333_333_333_333_4) - t56;
    let t62 = t61 * t57;
    let t63 = t58 * t57;
    let t64 = t21 * t3;
    let t65 = R::literal(0.833_333_333_333_333_4) + t64;
    let t66 = t65 * t57;
    let t67 = t23 * t3;
    let t68 = t67 * t57;
    let t69 = -t68;
    let t70 = t19 * t2;
    let t71 = R::literal(1.0) / (t50 - (t49 + R::literal(0.833_333_333_333_333_4) + t70))
        .sub_product(t55, t54).sub_product(t60, t59);
    let t72 = (t18 * t2).sub_product(t62, t59);
    let t73 = t72 * t71;
    let t74 = (R::literal(0.833_333_333_333_333_4) - t70).sub_product(t63, t59);
    let t75 = t74 * t71;
    let t76 = t21 * t2;
    let t77 = t76.add_product(t66, t59);
    let t78 = t77 * t71;
    let t79 = -t78;
    let t80 = t23 * t2;
    let t81 = (R::literal(0.833_333_333_333_333_4) + t80).add_product(t68, t59);
    let t82 = t81 * t71;
    let t83 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t56
        + R::literal(3.333_333_333_333_333_5)).add_product(t27, t5).add_product(t62, t61)
        .add_product(t73, t72);
    let t84 = -t83;
    let t85 = t58.add_product(t28, t5).sub_product(t63, t61).sub_product(t75, t72);
    let t86 = t85 * t83;
    let t87 = -t86;
    let t88 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t89 = t88 * t83;
    let t90 = (-t24).add_product(t30, t5);
    let t91 = t90 * t83;
    let t92 = -t91;
    let t93 = (t64 - R::literal(0.833_333_333_333_333_4)).sub_product(t66, t61).add_product(t78,
        t72);
    let t94 = t93 * t83;
    let t95 = -t94;
    let t96 = (-t67).add_product(t68, t61).sub_product(t82, t72);
    let t97 = t96 * t83;
    let t98 = -t97;
    let t99 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t70
        + R::literal(3.333_333_333_333_333_5)).add_product(t28, t4).add_product(t63, t58)
        .add_product(t75, t74)).add_product(t86, t85);
    let t100 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t89, t85);
    let t101 = t100 * t99;
    let t102 = t25.sub_product(t30, t4).add_product(t91, t85);
    let t103 = t102 * t99;
    let t104 = (-t76.add_product(t66, t58)).add_product(t78, t74).add_product(t94, t85);
    let t105 = t104 * t99;
    let t106 = (t80 - R::literal(0.833_333_333_333_333_4)).add_product(t68, t58).sub_product(t82,
        t74).add_product(t97, t85);
    let t107 = t106 * t99;
    let t108 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t89, t88)
        .sub_product(t101, t100);
    let t109 = t30.add_product(t91, t88).add_product(t103, t100);
    let t110 = t109 * t108;
    let t111 = -t110;
    let t112 = t35 * t108;
    let t113 = t37 * t108;
    let t114 = -t113;
    let t115 = (t94 * t88).add_product(t105, t100);
    let t116 = t115 * t108;
    let t117 = -t116;
    let t118 = (t97 * t88).add_product(t107, t100);
    let t119 = t118 * t108;
    let t120 = -t119;
    let t121 = R::literal(1.0) / (-(t24 * sin_cylinder_phi).add_product(t25, cos_cylinder_phi)
        .add_product(t30, slide).add_product(t32, sin_cylinder_phi).add_product(t34,
        cos_cylinder_phi)).add_product(t91, t90).sub_product(t103, t102).sub_product(t110, t109);
    let t122 = t32.add_product(t112, t109);
    let t123 = t122 * t121;
    let t124 = t34.add_product(t113, t109);
    let t125 = t124 * t121;
    let t126 = -t125;
    let t127 = (t94 * t90).sub_product(t105, t102).sub_product(t116, t109);
    let t128 = t127 * t121;
    let t129 = (t97 * t90).sub_product(t107, t102).sub_product(t119, t109);
    let t130 = t129 * t121;
    let t131 = R::literal(1.0) / R::literal(5.0).add_product(t35, t6).add_product(t112, t35)
        .add_product(t123, t122);
    let t132 = -t131;
    let t133 = (t37 * t6).add_product(t113, t35).add_product(t125, t122);
    let t134 = t133 * t131;
    let t135 = -t134;
    let t136 = (t116 * t35).sub_product(t128, t122);
    let t137 = t136 * t131;
    let t138 = -t137;
    let t139 = (t119 * t35).sub_product(t130, t122);
    let t140 = t139 * t131;
    let t141 = -t140;
    let t142 = R::literal(1.0) / (-R::literal(5.0).add_product(t37, R::literal(0.06) * cos_rod_phi)
        .add_product(t113, t37).add_product(t125, t124)).add_product(t134, t133);
    let t143 = (-(t116 * t37)).add_product(t128, t124).add_product(t137, t133);
    let t144 = t143 * t142;
    let t145 = (-(t119 * t37)).add_product(t130, t124).add_product(t140, t133);
    let t146 = t145 * t142;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t21, t13)
        + R::literal(1.428_571_428_571_428_6)).add_product(t66, t65).add_product(t78, t77))
        .add_product(t94, t93).sub_product(t105, t104).sub_product(t116, t115).sub_product(t128,
        t127).add_product(t137, t136).sub_product(t144, t143);
    let t148 = (t23 * t13).add_product(t68, t65).add_product(t82, t77).add_product(t97, t93)
        .sub_product(t107, t104).sub_product(t119, t115).sub_product(t130, t127).add_product(t140,
        t136).sub_product(t146, t143);
    let t149 = t148 * t147;
    let t150 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t23, t14)
        + R::literal(1.428_571_428_571_428_6)).add_product(t68, t67).add_product(t82, t81))
        .add_product(t97, t96).sub_product(t107, t106).sub_product(t119, t118).sub_product(t130,
        t129).add_product(t140, t139).sub_product(t146, t145).sub_product(t149, t148);
    let t151 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t7).add_product(R::literal(1500.0) * stop_rate, t7));
    let t152 = p.spring_stiffness * (slide - R::literal(0.116));
    let t153 = t152 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t154 = t153.add_product(spring_damping_times_slide_rate, cos_cylinder_phi);
    let t155 = t152 * sin_cylinder_phi;
    let t156 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t157 = t156 - (R::literal(2.943) - t155);
    let t158 = t152 * t12;
    let t159 = t158.add_product(spring_damping_times_slide_rate, t12);
    let t160 = t156 + (R::literal(1.962) + t155);
    let t161 = contact_stiffness_times_contact_gap * t8;
    let t162 = t161 / between;
    let t163 = contact_damping_times_contact_rate * t8;
    let t164 = contact_stiffness_times_contact_gap * t10 / between;
    let t165 = contact_damping_times_contact_rate * t10;
    let t166 = R::literal(0.1) * (post_omega * post_omega);
    let t167 = t166 * cos_post_phi;
    let t168 = t166 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t169 = R::literal(0.06) * plate_omega_squared;
    let t170 = t169 * cos_plate_phi;
    let t171 = t169 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t172 = R::literal(0.06) * (rod_omega * rod_omega);
    let t173 = t172 * cos_rod_phi;
    let t174 = t172 * sin_rod_phi;
    let t175 = t15 * t151;
    let t176 = t167 + t175;
    let t177 = t16 * t151;
    let t178 = t43 * t176;
    let t179 = R::literal(9.81) - t168 + t177 - t178;
    let t180 = (t170 + t167 + t175).add_product(t46, t176).add_product(t53, t179);
    let t181 = (t177 - (t171 + t168 + R::literal(9.81)) + R::literal(9.81) - t178).sub_product(t55,
        t179).add_product(t60, t180);
    let t182 = R::literal(3.333_333_333_333_333_5) * t154;
    let t183 = (-t182.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))).add_product(t27, t159)
        .add_product(t62, t180).sub_product(t73, t181);
    let t184 = R::literal(3.333_333_333_333_333_5) * t157;
    let t185 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t184)
        .add_product(t28, t159)).add_product(t63, t180).sub_product(t75, t181).add_product(t86,
        t183);
    let t186 = (R::literal(-2_777.777_777_777_778) * t159).sub_product(t89, t183).sub_product(t101,
        t185);
    let t187 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t24, t154)
        .add_product(t25, t157).sub_product(t30, t159).sub_product(t32, t154).add_product(t34, t160)
        .add_product(t91, t183).sub_product(t103, t185);
    let t188 = t187.add_product(t110, t186);
    let t189 = R::literal(5.0) * t154;
    let t190 = (t173 + t189).sub_product(t112, t186).sub_product(t123, t188);
    let t191 = R::literal(5.0) * t160;
    let t192 = (t174 + t191).add_product(t113, t186).add_product(t125, t188).add_product(t134,
        t190);
    let t193 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t162 + t163 / between));
    let t194 = (-t193).add_product(t14, plate_omega_squared).add_product(t66, t180)
        .add_product(t78, t181).add_product(t94, t183).sub_product(t105, t185).add_product(t116,
        t186).sub_product(t128, t188).add_product(t137, t190).sub_product(t144, t192);
    let t195 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t165 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t164)));
    let t196 = (R::literal(-9.81).add_product(t13, plate_omega_squared) - t195).sub_product(t68,
        t180).sub_product(t82, t181).add_product(t97, t183).sub_product(t107, t185)
        .add_product(t119, t186).sub_product(t130, t188).add_product(t140, t190).sub_product(t146,
        t192);
    let t197 = t149 * t194;
    let t198 = (t196 - t197) * t150;
    let t199 = (t194 * t147).sub_product(t149, t198);
    let t200 = (t192 * t142).sub_product(t144, t199).sub_product(t146, t198);
    let t201 = (-(t190 * t131)).add_product(t134, t200);
    let t202 = t137 * t199;
    let t203 = t140 * t198;
    let t204 = t201 + t202 + t203;
    let t205 = (t188 * t121).sub_product(t123, t204).add_product(t125, t200).sub_product(t128,
        t199);
    let t206 = t130 * t198;
    let t207 = t205 - t206;
    let t208 = (t186 * t108).add_product(t110, t207).sub_product(t112, t204).add_product(t113, t200)
        .add_product(t116, t199).add_product(t119, t198);
    let t209 = (t185 * t99).sub_product(t101, t208).sub_product(t103, t207).sub_product(t105, t199);
    let t210 = t107 * t198;
    let t211 = t209 - t210;
    let t212 = (-(t183 * t83)).add_product(t86, t211).sub_product(t89, t208).add_product(t91, t207)
        .add_product(t94, t199);
    let t213 = t97 * t198;
    let t214 = t212 + t213;
    let t215 = (t181 * t71).sub_product(t73, t214).sub_product(t75, t211).add_product(t78, t199)
        .sub_product(t82, t198);
    let t216 = (t180 * t57).add_product(t60, t215).add_product(t62, t214).add_product(t63, t211)
        .add_product(t66, t199);
    let t217 = t68 * t198;
    let t218 = t217 - t216;
    let t219 = (t179 * t51).sub_product(t53, t218).sub_product(t55, t215);
    let t220 = (t176 * t40).add_product(t43, t219).add_product(t46, t218).add_product(t43, t215);
    let bobbin_v_y_dot = t195.sub_product(R::literal(1.428_571_428_571_428_6), t198);
    let bobbin_v_x_dot = t193.sub_product(R::literal(1.428_571_428_571_428_6), t199);
    let rod_omega_dot = (t35 * t204).sub_product(R::literal(4_166.666_666_666_667), t208)
        .sub_product(t37, t200);
    let t221 = t191.add_product(t34, t207).add_product(R::literal(5.0), t200);
    let rod_v_x_dot = (-t189).add_product(t32, t207).sub_product(R::literal(5.0), t204);
    let cylinder_omega_dot = (-(t159 * R::literal(2_777.777_777_777_778)).add_product(t27, t214))
        .add_product(t28, t211).sub_product(R::literal(-2_777.777_777_777_778), t208)
        .add_product(t30, t207);
    let cylinder_v_y_dot = t184.sub_product(R::literal(3.333_333_333_333_333_5), t211)
        .add_product(t25, t207);
    let cylinder_v_x_dot = t182.sub_product(R::literal(3.333_333_333_333_333_5), t214)
        .sub_product(t24, t207);
    let plate_omega_dot = (t19 * t215).sub_product(t18, t218).sub_product(t18, t214)
        .add_product(t19, t211).add_product(t21, t199).sub_product(t23, t198);
    let t222 = R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t215)
        .add_product(R::literal(-0.833_333_333_333_333_4), t211);
    let t223 = R::literal(-0.833_333_333_333_333_4) * t198;
    let t224 = (R::literal(-0.833_333_333_333_333_4) * t214)
        .add_product(R::literal(0.833_333_333_333_333_4), t218);
    let post_omega_dot = (t151 * R::literal(370.370_370_370_370_3)).sub_product(t15, t220)
        .add_product(t16, t219).sub_product(t15, t218).add_product(t16, t215);
    let t225 = R::literal(9.81).add_product(R::literal(1.25), t219).add_product(R::literal(-1.25),
        t215);
    let t226 = (R::literal(-1.25) * t218).add_product(R::literal(1.25), t220);
    Motion {
        factors: [t15, t17, t44, t18, t47, t53, t20, t55, t60, R::literal(3.333_333_333_333_333_5),
            t27, t62, t73, t29, t63, t75, t87, R::literal(-2_777.777_777_777_778),
            R::literal(4_166.666_666_666_667), t89, t101, t24, t26, t31, t33, t34, t92, t103, t111,
            R::literal(5.0), t36, t112, t123, t37, t114, t126, t135, t22,
            R::literal(1.428_571_428_571_428_6), t66, t79, t95, t105, t117, t128, t138, t144, t23,
            t69, t82, t98, t107, t120, t130, t141, t146, t149, t150, t147, t142, t132, t121, t108,
            t99, t84, t71, t57, t51, t41, R::literal(2_777.777_777_777_778), R::literal(400.0),
            R::literal(0.833_333_333_333_333_4), R::literal(-0.833_333_333_333_333_4),
            R::literal(370.370_370_370_370_3), R::literal(1.25), R::literal(-1.25)],
        cos_post_phi,
        sin_post_phi,
        cos_plate_phi,
        sin_plate_phi,
        cos_cylinder_phi,
        sin_cylinder_phi,
        cos_rod_phi,
        sin_rod_phi,
        stop_gap,
        t7,
        t9,
        t11,
        between,
        slide,
        contact_rate,
        t12,
        slide_rate,
        t13,
        t14,
        t153,
        t155,
        t158,
        t161,
        t162,
        t163,
        t164,
        t165,
        t167,
        t168,
        t170,
        t171,
        t173,
        t174,
        t196,
        t197,
        t199,
        t200,
        t201,
        t202,
        t203,
        t205,
        t206,
        t209,
        t210,
        t212,
        t213,
        t215,
        t216,
        t217,
        t219,
        t220,
        bobbin_v_y_dot,
        bobbin_v_x_dot,
        rod_omega_dot,
        t221,
        rod_v_x_dot,
        cylinder_omega_dot,
        cylinder_v_y_dot,
        cylinder_v_x_dot,
        plate_omega_dot,
        t222,
        t223,
        t224,
        post_omega_dot,
        t225,
        t226,
    }
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

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 347 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 294] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x, bobbin_y, _, _,
        post_omega, _, _, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let m = &motion(time, state, p, c);
    let t0 = R::literal(0.1) * m.cos_post_phi;
    let t1 = R::literal(0.1) * m.sin_post_phi;
    let t2 = R::literal(0.06) * m.cos_plate_phi;
    let t3 = R::literal(0.06) * m.sin_plate_phi;
    let t4 = R::literal(0.06) * m.cos_cylinder_phi;
    let t5 = R::literal(0.06) * m.sin_cylinder_phi;
    let t6 = R::literal(0.06) * m.cos_rod_phi;
    let t7 = R::literal(0.06) * m.sin_rod_phi;
    let stop_rate = post_omega * m.t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let contact_gap = m.between - R::literal(0.1);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let t10 = (R::literal(0.1) * m.sin_plate_phi).sub_product(R::literal(0.01), m.cos_plate_phi);
    let t11 = p.spring_damping * m.slide_rate;
    let t12 = t11 * m.cos_cylinder_phi;
    let t13 = t11 * m.sin_cylinder_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t14 = cylinder_omega_squared * m.sin_cylinder_phi;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t15 = m.t205 - m.t206;
    let t16 = m.t209 - m.t210;
    let t17 = m.t212 + m.t213;
    let t18 = m.t217 - m.t216;
    let t19 = m.t7 * m.t7;
    let t20 = m.t168.sub_product(t0, m.post_omega_dot);
    let t21 = -m.t167.add_product(t1, m.post_omega_dot);
    let t22 = m.t171.sub_product(t2, m.plate_omega_dot);
    let t23 = -m.t170.add_product(t3, m.plate_omega_dot);
    let t24 = p.spring_stiffness * m.cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t25 = spring_damping_times_cylinder_omega * m.sin_cylinder_phi;
    let t26 = t25 - t24;
    let t27 = t26 * m.cos_cylinder_phi;
    let t28 = t26 * m.sin_cylinder_phi;
    let t29 = spring_damping_times_cylinder_omega * m.t12;
    let t30 = t29 * m.sin_cylinder_phi;
    let t31 = p.spring_stiffness * m.t12;
    let t32 = t31 * m.cos_cylinder_phi;
    let t33 = t24 - t25;
    let t34 = t33 * m.cos_cylinder_phi;
    let t35 = t33 * m.sin_cylinder_phi;
    let t36 = m.cos_cylinder_phi * t15;
    let t37 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t38 = (p.spring_stiffness * m.sin_cylinder_phi)
        .add_product(spring_damping_times_cylinder_omega, m.cos_cylinder_phi);
    let t39 = t38 * m.cos_cylinder_phi;
    let t40 = -t39;
    let t41 = t38 * m.sin_cylinder_phi;
    let t42 = -t41;
    let t43 = t31 * m.sin_cylinder_phi;
    let t44 = m.t153.add_product(t29, m.cos_cylinder_phi) + t43 + t12;
    let t45 = m.sin_cylinder_phi * t15;
    let t46 = (m.sin_cylinder_phi * m.cylinder_omega_dot).add_product(cylinder_omega_squared,
        m.cos_cylinder_phi);
    let t47 = p.spring_damping * (-(cylinder_omega * m.slide)).add_product(rod_v_y - cylinder_v_y,
        m.cos_cylinder_phi).sub_product(rod_v_x - cylinder_v_x, m.sin_cylinder_phi);
    let t48 = t47 * m.cos_cylinder_phi;
    let t49 = t12.add_product(t47, m.sin_cylinder_phi) + (m.t153 + t43);
    let t50 = m.t12 * m.t12;
    let t51 = R::literal(0.06) * cylinder_omega_squared;
    let t52 = ((rod_x - cylinder_x) * m.sin_cylinder_phi).sub_product(rod_y - cylinder_y,
        m.cos_cylinder_phi);
    let t53 = m.between * m.between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t54 = contact_stiffness_times_contact_gap / m.between;
    let t55 = p.contact_damping * m.contact_rate / m.between;
    let t56 = t53 * m.between;
    let t57 = c.t0 * m.contact_rate;
    let t58 = t57 * t8 * t9 / t56;
    let t59 = m.t161 * t9 / t56;
    let t60 = p.contact_stiffness * t8 * t9 / t53;
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t61 = R::literal(0.2) * post_omega;
    let t62 = -(t61 * m.cos_post_phi);
    let t63 = -(t61 * m.sin_post_phi);
    let t64 = R::literal(0.12) * plate_omega;
    let t65 = -(t64 * m.cos_plate_phi);
    let t66 = -(t64 * m.sin_plate_phi);
    let t67 = p.spring_damping * (m.cos_cylinder_phi * m.cos_cylinder_phi);
    let t68 = -t67;
    let t69 = p.spring_damping * m.sin_cylinder_phi * m.cos_cylinder_phi;
    let t70 = -t69;
    let t71 = p.spring_damping * m.t12;
    let t72 = t71 * m.cos_cylinder_phi;
    let t73 = R::literal(2.0) * cylinder_omega;
    let t74 = t73 * m.cos_cylinder_phi;
    let t75 = p.spring_damping * (m.sin_cylinder_phi * m.sin_cylinder_phi);
    let t76 = -t75;
    let t77 = t71 * m.sin_cylinder_phi;
    let t78 = t73 * m.sin_cylinder_phi;
    let t79 = -t72;
    let t80 = -t77;
    let t81 = R::literal(0.12) * cylinder_omega;
    let t82 = R::literal(0.12) * rod_omega;
    let t83 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), -(p.contact_damping
        * t8 * t9 / t53));
    let mut x = [[R::literal(0.0); 20]; 26];
    x[2][0] = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), (R::literal(3000.0)
        * m.stop_gap * stop_rate).add_product(R::literal(1_000_000.0), m.stop_gap * m.stop_gap)
        .sub_product(R::literal(1_000_000.0), t19)).sub_product(t0, m.t220).sub_product(t1, m.t219)
        .sub_product(t0, t18).sub_product(t1, m.t215);
    x[14][0] = t20;
    x[15][0] = t21;
    x[16][0] = t20;
    x[17][0] = t21;
    x[5][1] = (-(t2 * t18).add_product(t3, m.t215).add_product(t2, t17).add_product(t3, t16)
        .add_product(t10, m.t199)).add_product(m.t13, (m.t196 - m.t197) * m.factors[57]);
    x[16][1] = t22;
    x[17][1] = t23;
    x[18][1] = t22;
    x[19][1] = t23;
    x[24][1] = -(m.t13 * plate_omega_squared).add_product(t10, m.plate_omega_dot);
    x[25][1] = (m.t13 * m.plate_omega_dot).add_product(m.t14, plate_omega_squared);
    x[6][2] = t27;
    x[7][2] = t28;
    x[8][2] = t32 - t30 - m.t155 - t13 - t36;
    x[9][2] = t34;
    x[10][2] = t35;
    x[21][2] = t14 - t37;
    x[6][3] = t40;
    x[7][3] = t42;
    x[8][3] = t44 - t45;
    x[9][3] = t39;
    x[10][3] = t41;
    x[21][3] = -t46;
    x[6][4] = t32 + t48 - m.t155 - t13 - t36;
    x[7][4] = t49 - t45;
    x[8][4] = (p.spring_stiffness * m.slide * (m.slide - R::literal(0.116)))
        .add_product(p.spring_damping * m.slide, m.slide_rate).sub_product(p.spring_stiffness, t50)
        .sub_product(t47, m.t12).sub_product(t4, t17).sub_product(t5, t16).sub_product(t52, t15);
    x[9][4] = m.t155 + t13 - t32 - t48 + t36;
    x[10][4] = t45 - t49;
    x[18][4] = (-(t4 * m.cylinder_omega_dot)).add_product(t51, m.sin_cylinder_phi);
    x[19][4] = -(t5 * m.cylinder_omega_dot).add_product(t51, m.cos_cylinder_phi);
    x[21][4] = (-(m.cos_cylinder_phi * m.cylinder_v_x_dot)).add_product(cylinder_omega,
        (R::literal(2.0) * cylinder_v_x * m.sin_cylinder_phi).add_product(R::literal(2.0)
        * rod_v_y, m.cos_cylinder_phi).add_product(cylinder_x_times_cylinder_omega,
        m.cos_cylinder_phi).add_product(cylinder_y_times_cylinder_omega, m.sin_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_y, m.cos_cylinder_phi)
        .sub_product(R::literal(2.0) * rod_v_x, m.sin_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, m.cos_cylinder_phi)
        .sub_product(rod_y_times_cylinder_omega, m.sin_cylinder_phi))
        .sub_product(m.sin_cylinder_phi, m.cylinder_v_y_dot).sub_product(t52, m.cylinder_omega_dot)
        .add_product(m.cos_cylinder_phi, m.rod_v_x_dot).sub_product(m.sin_cylinder_phi, m.t221);
    x[6][5] = t34;
    x[7][5] = t35;
    x[8][5] = t30 + m.t155 + t13 - t32 + t36;
    x[9][5] = t27;
    x[10][5] = t28;
    x[21][5] = t37 - t14;
    x[6][6] = t39;
    x[7][6] = t41;
    x[8][6] = t45 - t44;
    x[9][6] = t40;
    x[10][6] = t42;
    x[21][6] = t46;
    x[11][7] = (t7 * m.t200).add_product(t6, m.t201 + m.t202 + m.t203);
    x[22][7] = (-m.t174).add_product(t6, m.rod_omega_dot);
    x[23][7] = m.t173.add_product(t7, m.rod_omega_dot);
    x[12][8] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t57 * m.t9 / t56
        + contact_stiffness_times_contact_gap * m.t9 / t56 - contact_damping_times_bobbin_v_x * t8
        / t53 - t54 - p.contact_stiffness * m.t9 / t53 - t55);
    x[13][8] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t58
        - contact_damping_times_bobbin_v_x * t9 / t53 - (t60 - t59));
    x[12][9] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t58 + t59
        - contact_damping_times_bobbin_v_y * t8 / t53 - t60);
    x[13][9] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t57 * m.t11 / t56
        - contact_damping_times_bobbin_v_y * t9 / t53 - t55 - (t54 + p.contact_stiffness * m.t11
        / t53 - contact_stiffness_times_contact_gap * m.t11 / t56));
    x[2][10] = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(-1500.0)
        * t19);
    x[14][10] = t62;
    x[15][10] = t63;
    x[16][10] = t62;
    x[17][10] = t63;
    x[16][11] = t65;
    x[17][11] = t66;
    x[18][11] = t65;
    x[19][11] = t66;
    x[24][11] = plate_omega * (R::literal(0.02) * m.cos_plate_phi).sub_product(R::literal(0.2),
        m.sin_plate_phi);
    x[25][11] = plate_omega * (R::literal(0.02) * m.sin_plate_phi).add_product(R::literal(0.2),
        m.cos_plate_phi);
    x[6][12] = t68;
    x[7][12] = t70;
    x[8][12] = t72;
    x[9][12] = t67;
    x[10][12] = t69;
    x[21][12] = -t74;
    x[6][13] = t70;
    x[7][13] = t76;
    x[8][13] = t77;
    x[9][13] = t69;
    x[10][13] = t75;
    x[21][13] = -t78;
    x[6][14] = t72;
    x[7][14] = t77;
    x[8][14] = -(p.spring_damping * t50);
    x[9][14] = t79;
    x[10][14] = t80;
    x[18][14] = -(t81 * m.cos_cylinder_phi);
    x[19][14] = -(t81 * m.sin_cylinder_phi);
    x[21][14] = R::literal(2.0) * (cylinder_x_times_cylinder_omega * m.sin_cylinder_phi)
        .add_product(rod_y_times_cylinder_omega, m.cos_cylinder_phi).add_product(rod_v_x,
        m.cos_cylinder_phi).add_product(rod_v_y, m.sin_cylinder_phi)
        .sub_product(cylinder_y_times_cylinder_omega, m.cos_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, m.sin_cylinder_phi).sub_product(cylinder_v_x,
        m.cos_cylinder_phi).sub_product(cylinder_v_y, m.sin_cylinder_phi);
    x[6][15] = t67;
    x[7][15] = t69;
    x[8][15] = t79;
    x[9][15] = t68;
    x[10][15] = t70;
    x[21][15] = t74;
    x[6][16] = t69;
    x[7][16] = t75;
    x[8][16] = t80;
    x[9][16] = t70;
    x[10][16] = t76;
    x[21][16] = t78;
    x[22][17] = t82 * m.cos_rod_phi;
    x[23][17] = t82 * m.sin_rod_phi;
    x[12][18] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(p.contact_damping * m.t9 / t53));
    x[13][18] = t83;
    x[12][19] = t83;
    x[13][19] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(p.contact_damping * m.t11 / t53));
    substitute(RATE_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), x[0][0], x[0][1],
        x[0][2], x[0][3], x[0][4], x[0][5], x[0][6], x[0][7], x[0][8], x[0][9], x[0][10], x[0][11],
        x[0][12], x[0][13], x[0][14], x[0][15], x[0][16], x[0][17], x[0][18], x[0][19], x[1][0],
        x[1][1], x[1][2], x[1][3], x[1][4], x[1][5], x[1][6], x[1][7], x[1][8], x[1][9], x[1][10],
        x[1][11], x[1][12], x[1][13], x[1][14], x[1][15], x[1][16], x[1][17], x[1][18], x[1][19],
        x[2][0], x[2][1], x[2][2], x[2][3], x[2][4], x[2][5], x[2][6], x[2][7], x[2][8], x[2][9],
        x[2][10], x[2][11], x[2][12], x[2][13], x[2][14], x[2][15], x[2][16], x[2][17], x[2][18],
        x[2][19], x[3][0], x[3][1], x[3][2], x[3][3], x[3][4], x[3][5], x[3][6], x[3][7], x[3][8],
        x[3][9], x[3][10], x[3][11], x[3][12], x[3][13], x[3][14], x[3][15], x[3][16], x[3][17],
        x[3][18], x[3][19], x[4][0], x[4][1], x[4][2], x[4][3], x[4][4], x[4][5], x[4][6], x[4][7],
        x[4][8], x[4][9], x[4][10], x[4][11], x[4][12], x[4][13], x[4][14], x[4][15], x[4][16],
        x[4][17], x[4][18], x[4][19], x[5][0], x[5][1], x[5][2], x[5][3], x[5][4], x[5][5],
        x[5][6], x[5][7], x[5][8], x[5][9], x[5][10], x[5][11], x[5][12], x[5][13], x[5][14],
        x[5][15], x[5][16], x[5][17], x[5][18], x[5][19], x[6][0], x[6][1], x[6][2], x[6][3],
        x[6][4], x[6][5], x[6][6], x[6][7], x[6][8], x[6][9], x[6][10], x[6][11], x[6][12],
        x[6][13], x[6][14], x[6][15], x[6][16], x[6][17], x[6][18], x[6][19], x[7][0], x[7][1],
        x[7][2], x[7][3], x[7][4], x[7][5], x[7][6], x[7][7], x[7][8], x[7][9], x[7][10], x[7][11],
        x[7][12], x[7][13], x[7][14], x[7][15], x[7][16], x[7][17], x[7][18], x[7][19], x[8][0],
        x[8][1], x[8][2], x[8][3], x[8][4], x[8][5], x[8][6], x[8][7], x[8][8], x[8][9], x[8][10],
        x[8][11], x[8][12], x[8][13], x[8][14], x[8][15], x[8][16], x[8][17], x[8][18], x[8][19],
        x[9][0], x[9][1], x[9][2], x[9][3], x[9][4], x[9][5], x[9][6], x[9][7], x[9][8], x[9][9],
        x[9][10], x[9][11], x[9][12], x[9][13], x[9][14], x[9][15], x[9][16], x[9][17], x[9][18],
        x[9][19], x[10][0], x[10][1], x[10][2], x[10][3], x[10][4], x[10][5], x[10][6], x[10][7],
        x[10][8], x[10][9], x[10][10], x[10][11], x[10][12], x[10][13], x[10][14], x[10][15],
        x[10][16], x[10][17], x[10][18], x[10][19], x[11][0], x[11][1], x[11][2], x[11][3],
        x[11][4], x[11][5], x[11][6], x[11][7], x[11][8], x[11][9], x[11][10], x[11][11],
        x[11][12], x[11][13], x[11][14], x[11][15], x[11][16], x[11][17], x[11][18], x[11][19],
        x[12][0], x[12][1], x[12][2], x[12][3], x[12][4], x[12][5], x[12][6], x[12][7], x[12][8],
        x[12][9], x[12][10], x[12][11], x[12][12], x[12][13], x[12][14], x[12][15], x[12][16],
        x[12][17], x[12][18], x[12][19], x[13][0], x[13][1], x[13][2], x[13][3], x[13][4],
        x[13][5], x[13][6], x[13][7], x[13][8], x[13][9], x[13][10], x[13][11], x[13][12],
        x[13][13], x[13][14], x[13][15], x[13][16], x[13][17], x[13][18], x[13][19]]
}

static RATE_JACOBIAN_STEPS: &[Step<'static>] = &[Step::less(14, &[(0, 2)]), Step::less(15,
    &[(1, 2), (2, 14)]), Step::less(16, &[(0, 2), (3, 5), (4, 14), (5, 15)]), Step::less(17,
    &[(1, 2), (6, 5), (2, 14), (7, 15), (8, 16)]), Step::less(18, &[(3, 5), (9, 6), (10, 8),
    (11, 16), (12, 17)]), Step::less(19, &[(6, 5), (9, 7), (13, 8), (14, 16), (15, 17), (16, 18)]),
    Step::less(20, &[(17, 8), (18, 11), (19, 18), (20, 19)]), Step::less(21, &[(21, 6), (22, 7),
    (23, 8), (24, 9), (25, 10), (26, 18), (27, 19), (28, 20)]), Step::less(22, &[(29, 9), (30, 11),
    (31, 20), (32, 21)]), Step::less(23, &[(29, 10), (33, 11), (34, 20), (35, 21), (36, 22)]),
    Step::less(24, &[(37, 5), (38, 12), (39, 16), (40, 17), (41, 18), (42, 19), (43, 20), (44, 21),
    (45, 22), (46, 23)]), Step::less(25, &[(47, 5), (38, 13), (48, 16), (49, 17), (50, 18),
    (51, 19), (52, 20), (53, 21), (54, 22), (55, 23), (56, 24)]), Step::scaled(25, 57, &[]),
    Step::scaled(24, 58, &[(56, 25)]), Step::scaled(23, 59, &[(46, 24), (55, 25)]),
    Step::scaled(22, 60, &[(36, 23), (45, 24), (54, 25)]), Step::scaled(21, 61,
    &[(32, 22), (35, 23), (44, 24), (53, 25)]), Step::scaled(20, 62, &[(28, 21), (31, 22),
    (34, 23), (43, 24), (52, 25)]), Step::scaled(19, 63, &[(20, 20), (27, 21), (42, 24),
    (51, 25)]), Step::scaled(18, 64, &[(16, 19), (19, 20), (26, 21), (41, 24), (50, 25)]),
    Step::scaled(17, 65, &[(12, 18), (15, 19), (40, 24), (49, 25)]), Step::scaled(16, 66,
    &[(8, 17), (11, 18), (14, 19), (39, 24), (48, 25)]), Step::scaled(15, 67, &[(5, 16), (7, 17)]),
    Step::scaled(14, 68, &[(2, 15), (4, 16), (2, 17)]), Step::scaled(13, 38, &[(38, 25)]),
    Step::scaled(12, 38, &[(38, 24)]), Step::scaled(11, 18, &[(18, 20), (30, 22), (33, 23)]),
    Step::scaled(10, 29, &[(25, 21), (29, 23)]), Step::scaled(9, 29, &[(24, 21), (29, 22)]),
    Step::scaled(8, 69, &[(10, 18), (13, 19), (17, 20), (23, 21)]), Step::scaled(7, 9,
    &[(9, 19), (22, 21)]), Step::scaled(6, 9, &[(9, 18), (21, 21)]), Step::scaled(5, 70,
    &[(3, 16), (6, 17), (3, 18), (6, 19), (37, 24), (47, 25)]), Step::less(4, &[(71, 17), (72, 19),
    (72, 25)]), Step::less(3, &[(71, 16), (72, 18), (72, 24)]), Step::scaled(2, 73,
    &[(0, 14), (1, 15), (0, 16), (1, 17)]), Step::less(1, &[(74, 15), (75, 17)]), Step::less(0,
    &[(74, 14), (75, 16)])];
/// `dy'/dp`, values in the order of its pattern. 57 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 56] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _, bobbin_x,
        bobbin_y, _, _, _, _, _, _, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y,
        _, bobbin_v_x, bobbin_v_y, contact_closed, ..] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let (sin_cylinder_phi, cos_cylinder_phi) = cylinder_phi.sin_cos();
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let t2 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t2)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t3 = slide - R::literal(0.116);
    let t4 = t3 * cos_cylinder_phi;
    let t5 = t3 * sin_cylinder_phi;
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let mut x = [[R::literal(0.0); 4]; 26];
    x[6][0] = t4;
    x[7][0] = t5;
    x[8][0] = -(t3 * t2);
    x[9][0] = -t4;
    x[10][0] = -t5;
    x[6][1] = slide_rate_times_cos_cylinder_phi;
    x[7][1] = slide_rate_times_sin_cylinder_phi;
    x[8][1] = -(slide_rate * t2);
    x[9][1] = -slide_rate_times_cos_cylinder_phi;
    x[10][1] = -slide_rate_times_sin_cylinder_phi;
    x[12][2] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), -(contact_gap * t0
        / between));
    x[13][2] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), -(contact_gap * t1
        / between));
    x[12][3] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), -(contact_rate * t0
        / between));
    x[13][3] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), -(contact_rate * t1
        / between));
    substitute(PARAMETER_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [x[0][0], x[0][1], x[0][2], x[0][3], x[1][0], x[1][1], x[1][2], x[1][3], x[2][0], x[2][1],
        x[2][2], x[2][3], x[3][0], x[3][1], x[3][2], x[3][3], x[4][0], x[4][1], x[4][2], x[4][3],
        x[5][0], x[5][1], x[5][2], x[5][3], x[6][0], x[6][1], x[6][2], x[6][3], x[7][0], x[7][1],
        x[7][2], x[7][3], x[8][0], x[8][1], x[8][2], x[8][3], x[9][0], x[9][1], x[9][2], x[9][3],
        x[10][0], x[10][1], x[10][2], x[10][3], x[11][0], x[11][1], x[11][2], x[11][3], x[12][0],
        x[12][1], x[12][2], x[12][3], x[13][0], x[13][1], x[13][2], x[13][3]]
}

static PARAMETER_JACOBIAN_STEPS: &[Step<'static>] = &[Step::less(18, &[(9, 6), (10, 8)]),
    Step::less(19, &[(9, 7), (13, 8), (16, 18)]), Step::less(20, &[(17, 8), (19, 18), (20, 19)]),
    Step::less(21, &[(21, 6), (22, 7), (23, 8), (24, 9), (25, 10), (26, 18), (27, 19), (28, 20)]),
    Step::less(22, &[(29, 9), (31, 20), (32, 21)]), Step::less(23, &[(29, 10), (34, 20), (35, 21),
    (36, 22)]), Step::less(24, &[(38, 12), (41, 18), (42, 19), (43, 20), (44, 21), (45, 22),
    (46, 23)]), Step::less(25, &[(38, 13), (50, 18), (51, 19), (52, 20), (53, 21), (54, 22),
    (55, 23), (56, 24)]), Step::scaled(25, 57, &[]), Step::scaled(24, 58, &[(56, 25)]),
    Step::scaled(23, 59, &[(46, 24), (55, 25)]), Step::scaled(22, 60, &[(36, 23), (45, 24),
    (54, 25)]), Step::scaled(21, 61, &[(32, 22), (35, 23), (44, 24), (53, 25)]), Step::scaled(20,
    62, &[(28, 21), (31, 22), (34, 23), (43, 24), (52, 25)]), Step::scaled(19, 63,
    &[(20, 20), (27, 21), (42, 24), (51, 25)]), Step::scaled(18, 64, &[(16, 19), (19, 20),
    (26, 21), (41, 24), (50, 25)]), Step::less(17, &[(12, 18), (15, 19), (40, 24), (49, 25)]),
    Step::less(16, &[(8, 17), (11, 18), (14, 19), (39, 24), (48, 25)]), Step::less(15,
    &[(5, 16), (7, 17)]), Step::less(14, &[(2, 15), (4, 16), (2, 17)]), Step::scaled(13, 38,
    &[(38, 25)]), Step::scaled(12, 38, &[(38, 24)]), Step::less(11, &[(18, 20), (30, 22),
    (33, 23)]), Step::scaled(10, 29, &[(25, 21), (29, 23)]), Step::scaled(9, 29,
    &[(24, 21), (29, 22)]), Step::scaled(8, 69, &[(10, 18), (13, 19), (17, 20), (23, 21)]),
    Step::scaled(7, 9, &[(9, 19), (22, 21)]), Step::scaled(6, 9, &[(9, 18), (21, 21)]),
    Step::less(5, &[(3, 16), (6, 17), (3, 18), (6, 19), (37, 24), (47, 25)]), Step::less(4,
    &[(71, 17), (72, 19), (72, 25)]), Step::less(3, &[(71, 16), (72, 18), (72, 24)]), Step::less(2,
    &[(0, 14), (1, 15), (0, 16), (1, 17)]), Step::less(1, &[(74, 15), (75, 17)]), Step::less(0,
    &[(74, 14), (75, 16)])];
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 109 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, _, _, _, _, _, _, _, _, _, _, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega,
        plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let stop_rate = post_omega * m.t7;
    let t0 = (R::literal(7.848) * post_v_y).add_product(R::select_less(stop_closed,
        R::literal(0.5), R::literal(0.0), R::literal(1_000_000.0) * m.stop_gap * m.t7), post_omega)
        .add_product(R::literal(11.772), plate_v_y).sub_product(m.t153, cylinder_v_x)
        .add_product(R::literal(2.943) - m.t155, cylinder_v_y).add_product(m.t158, cylinder_omega)
        .add_product(m.t153, rod_v_x).add_product(R::literal(1.962) + m.t155, rod_v_y)
        .add_product(R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t162),
        bobbin_v_x).add_product(R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5),
        R::literal(0.0), m.t164), bobbin_v_y).sub_product(R::literal(0.8) * post_v_x, m.t226)
        .sub_product(R::literal(0.8) * post_v_y, m.t225).add_product(R::literal(0.0027)
        * post_omega, m.post_omega_dot);
    let t1 = (p.spring_damping * cylinder_omega * m.slide_rate * m.t12)
        .add_product(p.spring_damping * rod_v_x * m.slide_rate, m.cos_cylinder_phi)
        .add_product(p.spring_damping * rod_v_y * m.slide_rate, m.sin_cylinder_phi)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), p.contact_damping
        * bobbin_v_x * m.contact_rate * (bobbin_x - R::literal(0.328)) / m.between
        + p.contact_damping * bobbin_v_y * m.contact_rate * (bobbin_y - R::literal(0.058))
        / m.between);
    PowerBalance {
        stored_rate: t0.sub_product(R::literal(1.2) * plate_v_x, m.t224
            .add_product(R::literal(-0.833_333_333_333_333_4), m.t199)).sub_product(R::literal(1.2)
            * plate_v_y, m.t222 + m.t223).add_product(R::literal(0.0025) * plate_omega,
            m.plate_omega_dot).add_product(R::literal(0.3) * cylinder_v_x, m.cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, m.cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, m.cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, m.rod_v_x_dot).sub_product(R::literal(0.2)
            * rod_v_y, m.t221).add_product(R::literal(0.00024) * rod_omega, m.rod_omega_dot)
            .add_product(R::literal(0.7) * bobbin_v_x, m.bobbin_v_x_dot)
            .add_product(R::literal(0.7) * bobbin_v_y, m.bobbin_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: (t1 + R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
            R::literal(1500.0) * (stop_rate * stop_rate))).sub_product(p.spring_damping
            * cylinder_v_x * m.slide_rate, m.cos_cylinder_phi).sub_product(p.spring_damping
            * cylinder_v_y * m.slide_rate, m.sin_cylinder_phi),
    }
}

/// What passes zero where events happen, one for each event. 31 operations.
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
    let t2 = R::literal(1_000_000.0) * stop_gap;
    let t3 = -t2;
    let stop_push = (-t2).add_product(R::literal(-1500.0), stop_rate);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let t4 = -contact_stiffness_times_contact_gap;
    let contact_push = -contact_stiffness_times_contact_gap.add_product(p.contact_damping,
        contact_rate);
    let stop_contact = R::select_less(t3, stop_push, t3, stop_push);
    let contact_contact = R::select_less(t4, contact_push, t4, contact_push);
    [contact_contact, contact_contact, stop_contact, stop_contact]
}

/// `dg/dt` of the guards along the motion. 59 operations.
#[must_use]
pub fn guard_rates<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let bobbin_x = state[12];
    let bobbin_y = state[13];
    let post_omega = state[16];
    let bobbin_v_x = state[26];
    let bobbin_v_y = state[27];
    let m = &motion(time, state, p, &prepare(p));
    let stop_rate = post_omega * m.t7;
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let contact_gap = m.between - R::literal(0.1);
    let t2 = R::literal(1_000_000.0) * m.stop_gap;
    let t3 = -t2;
    let stop_push = -t2.add_product(R::literal(1500.0), stop_rate);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let t4 = -contact_stiffness_times_contact_gap;
    let contact_push = -contact_stiffness_times_contact_gap.add_product(p.contact_damping,
        m.contact_rate);
    let t5 = m.between * m.between;
    let t6 = p.contact_stiffness * t0 / m.between;
    let t7 = p.contact_stiffness * t1 / m.between;
    let t8 = (R::select_less(t4, contact_push, -t6, m.t163 / t5 - p.contact_damping * bobbin_v_x
        / m.between - t6) * bobbin_v_x).add_product(R::select_less(t4, contact_push, -t7, m.t165
        / t5 - p.contact_damping * bobbin_v_y / m.between - t7), bobbin_v_y)
        .add_product(R::select_less(t4, contact_push, R::literal(0.0), -(p.contact_damping * t0
        / m.between)), m.bobbin_v_x_dot);
    let contact_touches_guard_rate = t8.add_product(R::select_less(t4, contact_push,
        R::literal(0.0), -(p.contact_damping * t1 / m.between)), m.bobbin_v_y_dot);
    let t9 = R::literal(1_000_000.0) * m.t7;
    let stop_touches_guard_rate = (R::select_less(t3, stop_push, -t9, (-t9)
        .add_product(R::literal(1500.0) * post_omega, m.stop_gap)) * post_omega)
        .add_product(R::select_less(t3, stop_push, R::literal(0.0), R::literal(-1500.0) * m.t7),
        m.post_omega_dot);
    [contact_touches_guard_rate, contact_touches_guard_rate, stop_touches_guard_rate,
        stop_touches_guard_rate]
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
