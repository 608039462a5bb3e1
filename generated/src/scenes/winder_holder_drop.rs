// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   044e0f4a1f2bab23afeb6e3d262a47321342ed9c5c3cc52995c00ca78c21b7a4  scenes/winder_holder_drop.toml
//   b4594591158f68ce8c9070674fa9b2138edb31e0a5645bf03c9d1c4965420587  units/planar_body.toml
//   f16080366c1876ed3761f64515d9615b15b3dbd6017cdb3eb0cba34abb073dd2  units/spring_damper.toml
//   975244d90bcd2ad5b18417df1a2902dfe173a10f5b4b8538d5616fd2a4d99061  units/one_sided_contact.toml
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
// Operations: initial_state 1, rate 722, forcing 78, rate_jacobian 4144, parameter_jacobian 57,
//     outputs 52, energy 78, power_balance 109, guards 31, guard_rates 59, constraint_values 49,
//     constraint_rates 63, constraint_matrix 30, prepare 1, prepared_rate 722,
//     prepared_rate_jacobian 4143, prepared_parameter_jacobian 57, motion 746.

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
    events; constraints; prepared; jacobians_apart;
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

/// What `rate` and its Jacobians need of the parameters, once a run. 1 operation.
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
    pub factors: [R; 70],
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
    pub t38: R,
    pub t40: R,
    pub t41: R,
    pub t50: R,
    pub t51: R,
    pub t52: R,
    pub t55: R,
    pub t57: R,
    pub t58: R,
    pub t59: R,
    pub t60: R,
    pub t65: R,
    pub t68: R,
    pub t72: R,
    pub t73: R,
    pub t74: R,
    pub t77: R,
    pub t79: R,
    pub t80: R,
    pub t85: R,
    pub t87: R,
    pub t89: R,
    pub t95: R,
    pub t97: R,
    pub t101: R,
    pub t106: R,
    pub t108: R,
    pub t113: R,
    pub t114: R,
    pub t121: R,
    pub t122: R,
    pub t126: R,
    pub t133: R,
    pub t135: R,
    pub t136: R,
    pub t139: R,
    pub t141: R,
    pub t144: R,
    pub t146: R,
    pub t147: R,
    pub t151: R,
    pub t152: R,
    pub t162: R,
    pub t167: R,
    pub t169: R,
    pub t172: R,
    pub t175: R,
    pub t176: R,
    pub t177: R,
    pub t178: R,
    pub t179: R,
    pub t181: R,
    pub t182: R,
    pub t184: R,
    pub t185: R,
    pub t187: R,
    pub t188: R,
    pub t210: R,
    pub t211: R,
    pub t213: R,
    pub t214: R,
    pub t215: R,
    pub t216: R,
    pub t217: R,
    pub t219: R,
    pub t220: R,
    pub t223: R,
    pub t224: R,
    pub t226: R,
    pub t227: R,
    pub t229: R,
    pub t230: R,
    pub t231: R,
    pub t233: R,
    pub t234: R,
    pub bobbin_v_y_dot: R,
    pub bobbin_v_x_dot: R,
    pub rod_omega_dot: R,
    pub t235: R,
    pub rod_v_x_dot: R,
    pub cylinder_omega_dot: R,
    pub cylinder_v_y_dot: R,
    pub cylinder_v_x_dot: R,
    pub plate_omega_dot: R,
    pub t236: R,
    pub t237: R,
    pub t238: R,
    pub post_omega_dot: R,
    pub t239: R,
    pub t240: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions
/// need. 746 operations.
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
    let t41 = t16 * t1;
    let t42 = t41 * t40;
    let t43 = -t42;
    let t44 = R::literal(1.25) - t38;
    let t45 = t44 * t40;
    let t46 = -t45;
    let t47 = t16 * t0;
    let t48 = R::literal(1.25) + t47;
    let t49 = t42 * t41;
    let t50 = R::literal(1.0) / (t49 - t48);
    let t51 = t15 * t0;
    let t52 = t45 * t41;
    let t53 = t51 + t52;
    let t54 = t53 * t50;
    let t55 = R::literal(1.25) - t47 + t49;
    let t56 = t55 * t50;
    let t57 = t18 * t3;
    let t58 = R::literal(1.0) / (-(t39 + R::literal(0.833_333_333_333_333_4) + t57))
        .add_product(t45, t44).sub_product(t54, t53);
    let t59 = t19 * t3;
    let t60 = (t41 + t59).add_product(t42, t44).sub_product(t56, t53);
    let t61 = t60 * t58;
    let t62 = R::literal(0.833_333_333_333_333_4) - t57;
    let t63 = t62 * t58;
    let t64 = t59 * t58;
    let t65 = t21 * t3;
    let t66 = R::literal(0.833_333_333_333_333_4) + t65;
    let t67 = t66 * t58;
    let t68 = t23 * t3;
    let t69 = t68 * t58;
    let t70 = -t69;
    let t71 = t19 * t2;
    let t72 = R::literal(1.0) / (t49 - (t48 + R::literal(0.833_333_333_333_333_4) + t71))
        .sub_product(t56, t55).sub_product(t61, t60);
    let t73 = t18 * t2;
    let t74 = t63 * t60;
    let t75 = t73 - t74;
    let t76 = t75 * t72;
    let t77 = (R::literal(0.833_333_333_333_333_4) - t71).sub_product(t64, t60);
    let t78 = t77 * t72;
    let t79 = t21 * t2;
    let t80 = t67 * t60;
    let t81 = t79 + t80;
    let t82 = t81 * t72;
    let t83 = -t82;
    let t84 = t23 * t2;
    let t85 = (R::literal(0.833_333_333_333_333_4) + t84).add_product(t69, t60);
    let t86 = t85 * t72;
    let t87 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t57
        + R::literal(3.333_333_333_333_333_5)).add_product(t27, t5).add_product(t63, t62)
        .add_product(t76, t75);
    let t88 = -t87;
    let t89 = t59.add_product(t28, t5).sub_product(t64, t62).sub_product(t78, t75);
    let t90 = t89 * t87;
    let t91 = -t90;
    let t92 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t93 = t92 * t87;
    let t94 = (-t24).add_product(t30, t5);
    let t95 = t94 * t87;
    let t96 = -t95;
    let t97 = (t65 - R::literal(0.833_333_333_333_333_4)).sub_product(t67, t62).add_product(t82,
        t75);
    let t98 = t97 * t87;
    let t99 = -t98;
    let t100 = (-t68).add_product(t69, t62).sub_product(t86, t75);
    let t101 = t100 * t87;
    let t102 = -t101;
    let t103 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t71
        + R::literal(3.333_333_333_333_333_5)).add_product(t28, t4).add_product(t64, t59)
        .add_product(t78, t77)).add_product(t90, t89);
    let t104 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t93, t89);
    let t105 = t104 * t103;
    let t106 = t25.sub_product(t30, t4).add_product(t95, t89);
    let t107 = t106 * t103;
    let t108 = (-t79.add_product(t67, t59)).add_product(t82, t77).add_product(t98, t89);
    let t109 = t108 * t103;
    let t110 = (t84 - R::literal(0.833_333_333_333_333_4)).add_product(t69, t59).sub_product(t86,
        t77).add_product(t101, t89);
    let t111 = t110 * t103;
    let t112 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t93, t92)
        .sub_product(t105, t104);
    let t113 = t30.add_product(t95, t92);
    let t114 = t107 * t104;
    let t115 = t113 + t114;
    let t116 = t115 * t112;
    let t117 = -t116;
    let t118 = t35 * t112;
    let t119 = t37 * t112;
    let t120 = -t119;
    let t121 = t98 * t92;
    let t122 = t109 * t104;
    let t123 = t121 + t122;
    let t124 = t123 * t112;
    let t125 = -t124;
    let t126 = (t101 * t92).add_product(t111, t104);
    let t127 = t126 * t112;
    let t128 = -t127;
    let t129 = R::literal(1.0) / (-(t24 * sin_cylinder_phi).add_product(t25, cos_cylinder_phi)
        .add_product(t30, slide).add_product(t32, sin_cylinder_phi).add_product(t34,
        cos_cylinder_phi)).add_product(t95, t94).sub_product(t107, t106).sub_product(t116, t115);
    let t130 = t32.add_product(t118, t115);
    let t131 = t130 * t129;
    let t132 = t34.add_product(t119, t115);
    let t133 = t132 * t129;
    let t134 = -t133;
    let t135 = (t98 * t94).sub_product(t109, t106);
    let t136 = t124 * t115;
    let t137 = t135 - t136;
    let t138 = t137 * t129;
    let t139 = (t101 * t94).sub_product(t111, t106).sub_product(t127, t115);
    let t140 = t139 * t129;
    let t141 = R::literal(1.0) / R::literal(5.0).add_product(t35, t6).add_product(t118, t35)
        .add_product(t131, t130);
    let t142 = -t141;
    let t143 = (t37 * t6).add_product(t119, t35).add_product(t133, t130);
    let t144 = t143 * t141;
    let t145 = -t144;
    let t146 = t124 * t35;
    let t147 = t138 * t130;
    let t148 = t146 - t147;
    let t149 = t148 * t141;
    let t150 = -t149;
    let t151 = t127 * t35;
    let t152 = t140 * t130;
    let t153 = t151 - t152;
    let t154 = t153 * t141;
    let t155 = -t154;
    let t156 = R::literal(1.0) / (-R::literal(5.0).add_product(t37, R::literal(0.06) * cos_rod_phi)
        .add_product(t119, t37).add_product(t133, t132)).add_product(t144, t143);
    let t157 = (-(t124 * t37)).add_product(t138, t132).add_product(t149, t143);
    let t158 = t157 * t156;
    let t159 = (-(t127 * t37)).add_product(t140, t132).add_product(t154, t143);
    let t160 = t159 * t156;
    let t161 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t21, t13)
        + R::literal(1.428_571_428_571_428_6)).add_product(t67, t66).add_product(t82, t81))
        .add_product(t98, t97).sub_product(t109, t108).sub_product(t124, t123).sub_product(t138,
        t137).add_product(t149, t148).sub_product(t158, t157);
    let t162 = (t23 * t13).add_product(t69, t66).add_product(t86, t81).add_product(t101, t97)
        .sub_product(t111, t108).sub_product(t127, t123).sub_product(t140, t137).add_product(t154,
        t148).sub_product(t160, t157);
    let t163 = t162 * t161;
    let t164 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t23, t14)
        + R::literal(1.428_571_428_571_428_6)).add_product(t69, t68).add_product(t86, t85))
        .add_product(t101, t100).sub_product(t111, t110).sub_product(t127, t126).sub_product(t140,
        t139).add_product(t154, t153).sub_product(t160, t159).sub_product(t163, t162);
    let t165 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t7).add_product(R::literal(1500.0) * stop_rate, t7));
    let t166 = p.spring_stiffness * (slide - R::literal(0.116));
    let t167 = t166 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t168 = t167.add_product(spring_damping_times_slide_rate, cos_cylinder_phi);
    let t169 = t166 * sin_cylinder_phi;
    let t170 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t171 = t170 - (R::literal(2.943) - t169);
    let t172 = t166 * t12;
    let t173 = t172.add_product(spring_damping_times_slide_rate, t12);
    let t174 = t170 + (R::literal(1.962) + t169);
    let t175 = contact_stiffness_times_contact_gap * t8;
    let t176 = t175 / between;
    let t177 = contact_damping_times_contact_rate * t8;
    let t178 = contact_stiffness_times_contact_gap * t10 / between;
    let t179 = contact_damping_times_contact_rate * t10;
    let t180 = R::literal(0.1) * (post_omega * post_omega);
    let t181 = t180 * cos_post_phi;
    let t182 = t180 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t183 = R::literal(0.06) * plate_omega_squared;
    let t184 = t183 * cos_plate_phi;
    let t185 = t183 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t186 = R::literal(0.06) * (rod_omega * rod_omega);
    let t187 = t186 * cos_rod_phi;
    let t188 = t186 * sin_rod_phi;
    let t189 = t15 * t165;
    let t190 = t181 + t189;
    let t191 = t16 * t165;
    let t192 = t42 * t190;
    let t193 = R::literal(9.81) - t182 + t191 - t192;
    let t194 = (t184 + t181 + t189).add_product(t45, t190).add_product(t54, t193);
    let t195 = (t191 - (t185 + t182 + R::literal(9.81)) + R::literal(9.81) - t192).sub_product(t56,
        t193).add_product(t61, t194);
    let t196 = R::literal(3.333_333_333_333_333_5) * t168;
    let t197 = (-t196.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))).add_product(t27, t173)
        .add_product(t63, t194).sub_product(t76, t195);
    let t198 = R::literal(3.333_333_333_333_333_5) * t171;
    let t199 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t198)
        .add_product(t28, t173)).add_product(t64, t194).sub_product(t78, t195).add_product(t90,
        t197);
    let t200 = (R::literal(-2_777.777_777_777_778) * t173).sub_product(t93, t197).sub_product(t105,
        t199);
    let t201 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t24, t168)
        .add_product(t25, t171).sub_product(t30, t173).sub_product(t32, t168).add_product(t34, t174)
        .add_product(t95, t197).sub_product(t107, t199);
    let t202 = t201.add_product(t116, t200);
    let t203 = R::literal(5.0) * t168;
    let t204 = (t187 + t203).sub_product(t118, t200).sub_product(t131, t202);
    let t205 = R::literal(5.0) * t174;
    let t206 = (t188 + t205).add_product(t119, t200).add_product(t133, t202).add_product(t144,
        t204);
    let t207 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t176 + t177 / between));
    let t208 = (-t207).add_product(t14, plate_omega_squared).add_product(t67, t194)
        .add_product(t82, t195).add_product(t98, t197).sub_product(t109, t199).add_product(t124,
        t200).sub_product(t138, t202).add_product(t149, t204).sub_product(t158, t206);
    let t209 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t179 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t178)));
    let t210 = (R::literal(-9.81).add_product(t13, plate_omega_squared) - t209).sub_product(t69,
        t194).sub_product(t86, t195).add_product(t101, t197).sub_product(t111, t199)
        .add_product(t127, t200).sub_product(t140, t202).add_product(t154, t204).sub_product(t160,
        t206);
    let t211 = t163 * t208;
    let t212 = (t210 - t211) * t164;
    let t213 = (t208 * t161).sub_product(t163, t212);
    let t214 = (t206 * t156).sub_product(t158, t213).sub_product(t160, t212);
    let t215 = (-(t204 * t141)).add_product(t144, t214);
    let t216 = t149 * t213;
    let t217 = t154 * t212;
    let t218 = t215 + t216 + t217;
    let t219 = (t202 * t129).sub_product(t131, t218).add_product(t133, t214).sub_product(t138,
        t213);
    let t220 = t140 * t212;
    let t221 = t219 - t220;
    let t222 = (t200 * t112).add_product(t116, t221).sub_product(t118, t218).add_product(t119, t214)
        .add_product(t124, t213).add_product(t127, t212);
    let t223 = (t199 * t103).sub_product(t105, t222).sub_product(t107, t221).sub_product(t109,
        t213);
    let t224 = t111 * t212;
    let t225 = t223 - t224;
    let t226 = (-(t197 * t87)).add_product(t90, t225).sub_product(t93, t222).add_product(t95, t221)
        .add_product(t98, t213);
    let t227 = t101 * t212;
    let t228 = t226 + t227;
    let t229 = (t195 * t72).sub_product(t76, t228).sub_product(t78, t225).add_product(t82, t213)
        .sub_product(t86, t212);
    let t230 = (t194 * t58).add_product(t61, t229).add_product(t63, t228).add_product(t64, t225)
        .add_product(t67, t213);
    let t231 = t69 * t212;
    let t232 = t231 - t230;
    let t233 = (t193 * t50).sub_product(t54, t232).sub_product(t56, t229);
    let t234 = (t190 * t40).add_product(t42, t233).add_product(t45, t232).add_product(t42, t229);
    let bobbin_v_y_dot = t209.sub_product(R::literal(1.428_571_428_571_428_6), t212);
    let bobbin_v_x_dot = t207.sub_product(R::literal(1.428_571_428_571_428_6), t213);
    let rod_omega_dot = (t35 * t218).sub_product(R::literal(4_166.666_666_666_667), t222)
        .sub_product(t37, t214);
    let t235 = t205.add_product(t34, t221).add_product(R::literal(5.0), t214);
    let rod_v_x_dot = (-t203).add_product(t32, t221).sub_product(R::literal(5.0), t218);
    let cylinder_omega_dot = (-(t173 * R::literal(2_777.777_777_777_778)).add_product(t27, t228))
        .add_product(t28, t225).sub_product(R::literal(-2_777.777_777_777_778), t222)
        .add_product(t30, t221);
    let cylinder_v_y_dot = t198.sub_product(R::literal(3.333_333_333_333_333_5), t225)
        .add_product(t25, t221);
    let cylinder_v_x_dot = t196.sub_product(R::literal(3.333_333_333_333_333_5), t228)
        .sub_product(t24, t221);
    let plate_omega_dot = (t19 * t229).sub_product(t18, t232).sub_product(t18, t228)
        .add_product(t19, t225).add_product(t21, t213).sub_product(t23, t212);
    let t236 = R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t229)
        .add_product(R::literal(-0.833_333_333_333_333_4), t225);
    let t237 = R::literal(-0.833_333_333_333_333_4) * t212;
    let t238 = (R::literal(-0.833_333_333_333_333_4) * t228)
        .add_product(R::literal(0.833_333_333_333_333_4), t232);
    let post_omega_dot = (t165 * R::literal(370.370_370_370_370_3)).sub_product(t15, t234)
        .add_product(t16, t233).sub_product(t15, t232).add_product(t16, t229);
    let t239 = R::literal(9.81).add_product(R::literal(1.25), t233).add_product(R::literal(-1.25),
        t229);
    let t240 = (R::literal(-1.25) * t232).add_product(R::literal(1.25), t234);
    Motion {
        factors: [R::literal(3.333_333_333_333_333_5), t27, t29, t91,
            R::literal(-2_777.777_777_777_778), t93, t105, t24, t26, t31, t33, t34, t96, t107,
            t117, R::literal(5.0), t118, t131, t120, t134, t145,
            R::literal(1.428_571_428_571_428_6), t99, t109, t125, t138, t150, t158, t102, t111,
            t128, t140, t155, t160, t163, t164, t161, t156, t142, t129, t112, t103, t88, t76, t78,
            t83, t86, t61, t63, t64, t67, t70, t54, t56, t43, t46,
            R::literal(4_166.666_666_666_667), t36, t37, R::literal(2_777.777_777_777_778), t18,
            t20, t22, t23, R::literal(0.833_333_333_333_333_4),
            R::literal(-0.833_333_333_333_333_4), t15, t17, R::literal(1.25), R::literal(-1.25)],
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
        t38,
        t40,
        t41,
        t50,
        t51,
        t52,
        t55,
        t57,
        t58,
        t59,
        t60,
        t65,
        t68,
        t72,
        t73,
        t74,
        t77,
        t79,
        t80,
        t85,
        t87,
        t89,
        t95,
        t97,
        t101,
        t106,
        t108,
        t113,
        t114,
        t121,
        t122,
        t126,
        t133,
        t135,
        t136,
        t139,
        t141,
        t144,
        t146,
        t147,
        t151,
        t152,
        t162,
        t167,
        t169,
        t172,
        t175,
        t176,
        t177,
        t178,
        t179,
        t181,
        t182,
        t184,
        t185,
        t187,
        t188,
        t210,
        t211,
        t213,
        t214,
        t215,
        t216,
        t217,
        t219,
        t220,
        t223,
        t224,
        t226,
        t227,
        t229,
        t230,
        t231,
        t233,
        t234,
        bobbin_v_y_dot,
        bobbin_v_x_dot,
        rod_omega_dot,
        t235,
        rod_v_x_dot,
        cylinder_omega_dot,
        cylinder_v_y_dot,
        cylinder_v_x_dot,
        plate_omega_dot,
        t236,
        t237,
        t238,
        post_omega_dot,
        t239,
        t240,
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

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 4143 operations.
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
    let t11 = R::literal(37.037_037_037_037_03) * m.cos_post_phi;
    let t12 = R::literal(24.0) * m.cos_plate_phi;
    let t13 = m.t13 * R::literal(400.0);
    let t14 = m.cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t15 = R::literal(166.666_666_666_666_66) * m.cos_cylinder_phi;
    let t16 = m.slide * R::literal(2_777.777_777_777_778);
    let t17 = m.sin_cylinder_phi * R::literal(5.0);
    let t18 = R::literal(250.0) * m.sin_rod_phi;
    let t19 = m.t41 * m.t40;
    let t20 = (R::literal(1.25) - m.t38) * m.t40;
    let t21 = m.t68 * m.t58;
    let t22 = (m.t79 + m.t80) * m.t72;
    let t23 = m.t89 * m.t87;
    let t24 = m.t97 * m.t87;
    let t25 = (m.t113 + m.t114) * m.factors[40];
    let t26 = m.factors[58] * m.factors[40];
    let t27 = (m.t121 + m.t122) * m.factors[40];
    let t28 = m.t126 * m.factors[40];
    let t29 = (m.t146 - m.t147) * m.t141;
    let t30 = (m.t151 - m.t152) * m.t141;
    let t31 = p.spring_damping * m.slide_rate;
    let t32 = t31 * m.cos_cylinder_phi;
    let t33 = t31 * m.sin_cylinder_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t34 = cylinder_omega_squared * m.sin_cylinder_phi;
    let t35 = R::literal(2.0) * cylinder_v_x;
    let t36 = R::literal(2.0) * cylinder_v_y;
    let t37 = R::literal(2.0) * rod_v_x;
    let t38 = R::literal(2.0) * rod_v_y;
    let t39 = m.t219 - m.t220;
    let t40 = m.t223 - m.t224;
    let t41 = m.t226 + m.t227;
    let t42 = m.t231 - m.t230;
    let t43 = m.t7 * m.t7;
    let t44 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), (R::literal(3000.0)
        * m.stop_gap * stop_rate).add_product(R::literal(1_000_000.0), m.stop_gap * m.stop_gap)
        .sub_product(R::literal(1_000_000.0), t43)).sub_product(t0, m.t234).sub_product(t1, m.t233)
        .sub_product(t0, t42).sub_product(t1, m.t229);
    let t45 = (-(t2 * t42).add_product(t3, m.t229).add_product(t2, t41).add_product(t3, t40)
        .add_product(t10, m.t213)).add_product(m.t13, (m.t210 - m.t211) * m.factors[35]);
    let t46 = p.spring_stiffness * m.cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t47 = spring_damping_times_cylinder_omega * m.sin_cylinder_phi;
    let t48 = t47 - t46;
    let t49 = t48 * m.cos_cylinder_phi;
    let t50 = t48 * m.sin_cylinder_phi;
    let t51 = spring_damping_times_cylinder_omega * m.t12;
    let t52 = t51 * m.sin_cylinder_phi;
    let t53 = p.spring_stiffness * m.t12;
    let t54 = t53 * m.cos_cylinder_phi;
    let t55 = t46 - t47;
    let t56 = t55 * m.cos_cylinder_phi;
    let t57 = t55 * m.sin_cylinder_phi;
    let t58 = m.cos_cylinder_phi * t39;
    let t59 = t54 - t52 - m.t169 - t33 - t58;
    let t60 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t61 = (p.spring_stiffness * m.sin_cylinder_phi)
        .add_product(spring_damping_times_cylinder_omega, m.cos_cylinder_phi);
    let t62 = t61 * m.cos_cylinder_phi;
    let t63 = t61 * m.sin_cylinder_phi;
    let t64 = t53 * m.sin_cylinder_phi;
    let t65 = m.t167.add_product(t51, m.cos_cylinder_phi) + t64 + t32;
    let t66 = m.sin_cylinder_phi * t39;
    let t67 = t65 - t66;
    let t68 = (m.sin_cylinder_phi * m.cylinder_omega_dot).add_product(cylinder_omega_squared,
        m.cos_cylinder_phi);
    let t69 = p.spring_damping * (-(cylinder_omega * m.slide)).add_product(rod_v_y - cylinder_v_y,
        m.cos_cylinder_phi).sub_product(rod_v_x - cylinder_v_x, m.sin_cylinder_phi);
    let t70 = t69 * m.cos_cylinder_phi;
    let t71 = t32.add_product(t69, m.sin_cylinder_phi) + (m.t167 + t64);
    let t72 = m.t12 * m.t12;
    let t73 = R::literal(0.06) * cylinder_omega_squared;
    let t74 = t54 + t70 - m.t169 - t33 - t58;
    let t75 = t71 - t66;
    let t76 = ((rod_x - cylinder_x) * m.sin_cylinder_phi).sub_product(rod_y - cylinder_y,
        m.cos_cylinder_phi);
    let t77 = (p.spring_stiffness * m.slide * (m.slide - R::literal(0.116)))
        .add_product(p.spring_damping * m.slide, m.slide_rate).sub_product(p.spring_stiffness, t72)
        .sub_product(t69, m.t12).sub_product(t4, t41).sub_product(t5, t40).sub_product(t76, t39);
    let t78 = m.t169 + t33 - t54 - t70 + t58;
    let t79 = t66 - t71;
    let t80 = t52 + m.t169 + t33 - t54 + t58;
    let t81 = t66 - t65;
    let t82 = (t7 * m.t214).add_product(t6, m.t215 + m.t216 + m.t217);
    let t83 = m.between * m.between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t84 = contact_stiffness_times_contact_gap / m.between;
    let t85 = p.contact_damping * m.contact_rate / m.between;
    let t86 = t83 * m.between;
    let t87 = c.t0 * m.contact_rate;
    let t88 = t87 * t8 * t9 / t86;
    let t89 = m.t175 * t9 / t86;
    let t90 = p.contact_stiffness * t8 * t9 / t83;
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t91 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(-1500.0)
        * t43);
    let t92 = R::literal(0.2) * post_omega;
    let t93 = R::literal(0.12) * plate_omega;
    let t94 = t93 * m.cos_plate_phi;
    let t95 = t93 * m.sin_plate_phi;
    let t96 = p.spring_damping * (m.cos_cylinder_phi * m.cos_cylinder_phi);
    let t97 = p.spring_damping * m.sin_cylinder_phi * m.cos_cylinder_phi;
    let t98 = p.spring_damping * m.t12;
    let t99 = t98 * m.cos_cylinder_phi;
    let t100 = R::literal(2.0) * cylinder_omega;
    let t101 = t100 * m.cos_cylinder_phi;
    let t102 = p.spring_damping * (m.sin_cylinder_phi * m.sin_cylinder_phi);
    let t103 = t98 * m.sin_cylinder_phi;
    let t104 = t100 * m.sin_cylinder_phi;
    let t105 = p.spring_damping * t72;
    let t106 = R::literal(0.12) * cylinder_omega;
    let t107 = R::literal(0.12) * rod_omega;
    let t108 = t107 * m.cos_rod_phi;
    let t109 = m.t182.sub_product(t0, m.post_omega_dot).sub_product(m.factors[66], t44);
    let t110 = (-m.t181.add_product(t1, m.post_omega_dot)).add_product(t11, t44).add_product(t19,
        t109);
    let t111 = t109.add_product(t20, t109).sub_product(m.factors[52], t110);
    let t112 = t110.sub_product(m.factors[53], t110).sub_product(m.factors[47], t111);
    let t113 = (m.factors[48] * t111).add_product(m.factors[43], t112);
    let t114 = (m.factors[49] * t111).add_product(m.factors[44], t112).add_product(t23, t113);
    let t115 = (m.factors[5] * t113).add_product(m.factors[6], t114);
    let t116 = (-(m.t95 * t113)).add_product(m.factors[13], t114).add_product(t25, t115);
    let t117 = (m.factors[16] * t115).add_product(m.factors[17], t116);
    let t118 = (t26 * t115).add_product(m.t133, t116).sub_product(m.t144, t117);
    let t119 = (-(m.factors[50] * t111)).add_product(t22, t112).sub_product(t24, t113)
        .add_product(m.factors[23], t114).add_product(t27, t115).sub_product(m.factors[25], t116)
        .sub_product(t29, t117).sub_product(m.factors[27], t118);
    let t120 = (t21 * t111).sub_product(m.factors[46], t112).sub_product(m.t101, t113)
        .add_product(m.factors[29], t114).add_product(t28, t115).sub_product(m.factors[31], t116)
        .sub_product(t30, t117).sub_product(m.factors[33], t118).sub_product(m.factors[34], t119)
        * m.factors[35];
    let t121 = (t119 * m.factors[36]).sub_product(m.factors[34], t120);
    let t122 = (t118 * m.factors[37]).sub_product(m.factors[27], t121).sub_product(m.factors[33],
        t120);
    let t123 = (t117 * m.t141).add_product(m.t144, t122).add_product(t29, t121).add_product(t30,
        t120);
    let t124 = (t116 * m.factors[39]).sub_product(m.factors[17], t123).add_product(m.t133, t122)
        .sub_product(m.factors[25], t121).sub_product(m.factors[31], t120);
    let t125 = (t115 * m.factors[40]).add_product(t25, t124).sub_product(m.factors[16], t123)
        .add_product(t26, t122).add_product(t27, t121).add_product(t28, t120);
    let t126 = (t114 * m.factors[41]).add_product(m.factors[6], t125).add_product(m.factors[13],
        t124).add_product(m.factors[23], t121).add_product(m.factors[29], t120);
    let t127 = (t113 * m.t87).sub_product(t23, t126).sub_product(m.factors[5], t125)
        .add_product(m.t95, t124).add_product(t24, t121).add_product(m.t101, t120);
    let t128 = (t112 * m.t72).sub_product(m.factors[43], t127).add_product(m.factors[44], t126)
        .add_product(t22, t121).sub_product(m.factors[46], t120);
    let t129 = (t111 * m.t58).sub_product(m.factors[47], t128).sub_product(m.factors[48], t127)
        .add_product(m.factors[49], t126).sub_product(m.factors[50], t121).add_product(t21, t120);
    let t130 = (t110 * m.t50).sub_product(m.factors[52], t129).sub_product(m.factors[53], t128);
    let t131 = (-(t109 * m.t40)).add_product(t19, t130).add_product(t20, t129).add_product(t19,
        t128);
    let bobbin_v_y_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t120;
    let bobbin_v_x_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t121;
    let rod_omega_dot_by_post_phi = (t18 * t123).sub_product(R::literal(4_166.666_666_666_667),
        t125).sub_product(m.factors[58], t122);
    let rod_v_y_dot_by_post_phi = (R::literal(-5.0) * t122).sub_product(m.factors[11], t124);
    let rod_v_x_dot_by_post_phi = (R::literal(-5.0) * t123).add_product(t17, t124);
    let cylinder_omega_dot_by_post_phi = (-(t15 * t126).add_product(m.factors[1], t127)
        .add_product(R::literal(-2_777.777_777_777_778), t125)).add_product(t16, t124);
    let cylinder_v_y_dot_by_post_phi = (t14 * t124)
        .add_product(R::literal(3.333_333_333_333_333_5), t126);
    let cylinder_v_x_dot_by_post_phi = (-(m.factors[7] * t124))
        .add_product(R::literal(-3.333_333_333_333_333_5), t127);
    let plate_omega_dot_by_post_phi = (t12 * t128).sub_product(m.factors[60], t129)
        .sub_product(m.factors[60], t127).sub_product(t12, t126).add_product(t13, t121)
        .sub_product(m.factors[63], t120);
    let plate_v_y_dot_by_post_phi = (R::literal(-0.833_333_333_333_333_4) * t126)
        .sub_product(R::literal(0.833_333_333_333_333_4), t128)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t120);
    let plate_v_x_dot_by_post_phi = (R::literal(0.833_333_333_333_333_4) * t127)
        .add_product(R::literal(-0.833_333_333_333_333_4), t129)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t121);
    let post_omega_dot_by_post_phi = (t44 * R::literal(370.370_370_370_370_3))
        .sub_product(m.factors[66], t131).add_product(t11, t130).sub_product(m.factors[66], t129)
        .add_product(t11, t128);
    let post_v_y_dot_by_post_phi = (R::literal(1.25) * t128).add_product(R::literal(-1.25), t130);
    let post_v_x_dot_by_post_phi = (R::literal(1.25) * t129).add_product(R::literal(-1.25), t131);
    let t132 = m.t185.sub_product(t2, m.plate_omega_dot).sub_product(m.factors[60], t45);
    let t133 = (-m.t184.add_product(t3, m.plate_omega_dot)).add_product(t12, t45);
    let t134 = t133.sub_product(m.factors[47], t132);
    let t135 = t132.sub_product(m.factors[48], t132).sub_product(m.factors[43], t134);
    let t136 = t133.sub_product(m.factors[49], t132).sub_product(m.factors[44], t134)
        .add_product(t23, t135);
    let t137 = (m.factors[5] * t135).add_product(m.factors[6], t136);
    let t138 = (m.t95 * t135).sub_product(m.factors[13], t136).sub_product(t25, t137);
    let t139 = (m.factors[16] * t137).sub_product(m.factors[17], t138);
    let t140 = (-(t26 * t137)).add_product(m.t133, t138).add_product(m.t144, t139);
    let t141 = (-(m.t13 * plate_omega_squared).add_product(t10, m.plate_omega_dot))
        .add_product(t13, t45).sub_product(m.factors[50], t132).add_product(t22, t134)
        .add_product(t24, t135).sub_product(m.factors[23], t136).sub_product(t27, t137)
        .sub_product(m.factors[25], t138).add_product(t29, t139).sub_product(m.factors[27], t140);
    let t142 = (m.t13 * m.plate_omega_dot).add_product(m.t14, plate_omega_squared)
        .sub_product(m.factors[63], t45).add_product(t21, t132).sub_product(m.factors[46], t134)
        .add_product(m.t101, t135).sub_product(m.factors[29], t136).sub_product(t28, t137)
        .sub_product(m.factors[31], t138).add_product(t30, t139).sub_product(m.factors[33], t140)
        .sub_product(m.factors[34], t141) * m.factors[35];
    let t143 = (t141 * m.factors[36]).sub_product(m.factors[34], t142);
    let t144 = (t140 * m.factors[37]).sub_product(m.factors[27], t143).sub_product(m.factors[33],
        t142);
    let t145 = (-(t139 * m.t141)).add_product(m.t144, t144).add_product(t29, t143).add_product(t30,
        t142);
    let t146 = (t138 * m.factors[39]).sub_product(m.factors[17], t145).add_product(m.t133, t144)
        .sub_product(m.factors[25], t143).sub_product(m.factors[31], t142);
    let t147 = (-(t137 * m.factors[40])).add_product(t25, t146).sub_product(m.factors[16], t145)
        .add_product(t26, t144).add_product(t27, t143).add_product(t28, t142);
    let t148 = (t136 * m.factors[41]).sub_product(m.factors[6], t147).sub_product(m.factors[13],
        t146).sub_product(m.factors[23], t143).sub_product(m.factors[29], t142);
    let t149 = (-(t135 * m.t87)).add_product(t23, t148).sub_product(m.factors[5], t147)
        .add_product(m.t95, t146).add_product(t24, t143).add_product(m.t101, t142);
    let t150 = (t134 * m.t72).sub_product(m.factors[43], t149).sub_product(m.factors[44], t148)
        .add_product(t22, t143).sub_product(m.factors[46], t142);
    let t151 = (t132 * m.t58).sub_product(m.factors[47], t150).sub_product(m.factors[48], t149)
        .sub_product(m.factors[49], t148).sub_product(m.factors[50], t143).add_product(t21, t142);
    let t152 = (m.factors[53] * t150).add_product(m.factors[52], t151);
    let t153 = (t20 * t151).sub_product(t19, t152).add_product(t19, t150);
    let bobbin_v_y_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t142;
    let bobbin_v_x_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t143;
    let rod_omega_dot_by_plate_phi = (t18 * t145).sub_product(R::literal(4_166.666_666_666_667),
        t147).sub_product(m.factors[58], t144);
    let rod_v_y_dot_by_plate_phi = (R::literal(-5.0) * t144).sub_product(m.factors[11], t146);
    let rod_v_x_dot_by_plate_phi = (R::literal(-5.0) * t145).add_product(t17, t146);
    let cylinder_omega_dot_by_plate_phi = (t15 * t148).sub_product(m.factors[1], t149)
        .sub_product(R::literal(-2_777.777_777_777_778), t147).add_product(t16, t146);
    let cylinder_v_y_dot_by_plate_phi = (t14 * t146)
        .sub_product(R::literal(3.333_333_333_333_333_5), t148);
    let cylinder_v_x_dot_by_plate_phi = (-(m.factors[7] * t146))
        .add_product(R::literal(-3.333_333_333_333_333_5), t149);
    let plate_omega_dot_by_plate_phi = (t45 * R::literal(400.0)).sub_product(m.factors[60], t151)
        .add_product(t12, t150).sub_product(m.factors[60], t149).add_product(t12, t148)
        .add_product(t13, t143).sub_product(m.factors[63], t142);
    let plate_v_y_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t148)
        .add_product(R::literal(-0.833_333_333_333_333_4), t150)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t142);
    let plate_v_x_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t149)
        .add_product(R::literal(-0.833_333_333_333_333_4), t151)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t143);
    let post_omega_dot_by_plate_phi = (-(t11 * t152).add_product(m.factors[66], t153)
        .add_product(m.factors[66], t151)).add_product(t11, t150);
    let post_v_y_dot_by_plate_phi = (R::literal(1.25) * t150).add_product(R::literal(1.25), t152);
    let post_v_x_dot_by_plate_phi = (R::literal(1.25) * t151).add_product(R::literal(-1.25), t153);
    let t154 = R::literal(3.333_333_333_333_333_5) * t49;
    let t155 = t154.add_product(m.factors[1], t59);
    let t156 = R::literal(3.333_333_333_333_333_5) * t50;
    let t157 = (-t156).add_product(t15, t59).sub_product(t23, t155);
    let t158 = (R::literal(2_777.777_777_777_778) * t59).add_product(m.factors[5], t155)
        .sub_product(m.factors[6], t157);
    let t159 = (t34 - t60).sub_product(m.factors[7], t49).add_product(t14, t50).add_product(t16,
        t59).add_product(t17, t56).sub_product(m.factors[11], t57).sub_product(m.t95, t155)
        .sub_product(m.factors[13], t157).add_product(t25, t158);
    let t160 = R::literal(5.0) * t56;
    let t161 = t160.add_product(m.factors[16], t158).add_product(m.factors[17], t159);
    let t162 = R::literal(5.0) * t57;
    let t163 = (-t162).add_product(t26, t158).add_product(m.t133, t159).sub_product(m.t144, t161);
    let t164 = (-(t24 * t155).add_product(m.factors[23], t157)).add_product(t27, t158)
        .sub_product(m.factors[25], t159).sub_product(t29, t161).sub_product(m.factors[27], t163);
    let t165 = (-(m.t101 * t155).add_product(m.factors[29], t157)).add_product(t28, t158)
        .sub_product(m.factors[31], t159).sub_product(t30, t161).sub_product(m.factors[33], t163)
        .sub_product(m.factors[34], t164) * m.factors[35];
    let t166 = (t164 * m.factors[36]).sub_product(m.factors[34], t165);
    let t167 = (t163 * m.factors[37]).sub_product(m.factors[27], t166).sub_product(m.factors[33],
        t165);
    let t168 = (t161 * m.t141).add_product(m.t144, t167).add_product(t29, t166).add_product(t30,
        t165);
    let t169 = (t159 * m.factors[39]).sub_product(m.factors[17], t168).add_product(m.t133, t167)
        .sub_product(m.factors[25], t166).sub_product(m.factors[31], t165);
    let t170 = (t158 * m.factors[40]).add_product(t25, t169).sub_product(m.factors[16], t168)
        .add_product(t26, t167).add_product(t27, t166).add_product(t28, t165);
    let t171 = (t157 * m.factors[41]).sub_product(m.factors[6], t170).sub_product(m.factors[13],
        t169).sub_product(m.factors[23], t166).sub_product(m.factors[29], t165);
    let t172 = (t155 * m.t87).add_product(t23, t171).sub_product(m.factors[5], t170)
        .add_product(m.t95, t169).add_product(t24, t166).add_product(m.t101, t165);
    let t173 = (-(m.factors[44] * t171).add_product(m.factors[43], t172)).add_product(t22, t166)
        .sub_product(m.factors[46], t165);
    let t174 = (-(m.factors[48] * t172).add_product(m.factors[47], t173).add_product(m.factors[49],
        t171).add_product(m.factors[50], t166)).add_product(t21, t165);
    let t175 = (m.factors[53] * t173).add_product(m.factors[52], t174);
    let t176 = (t20 * t174).sub_product(t19, t175).add_product(t19, t173);
    let bobbin_v_y_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t165;
    let bobbin_v_x_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t166;
    let rod_omega_dot_by_cylinder_x = (t18 * t168).sub_product(R::literal(4_166.666_666_666_667),
        t170).sub_product(m.factors[58], t167);
    let rod_v_y_dot_by_cylinder_x = t162.sub_product(m.factors[11], t169)
        .sub_product(R::literal(5.0), t167);
    let rod_v_x_dot_by_cylinder_x = t160.add_product(t17, t169).sub_product(R::literal(5.0), t168);
    let cylinder_omega_dot_by_cylinder_x = (t59 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t172).add_product(t15, t171)
        .sub_product(R::literal(-2_777.777_777_777_778), t170).add_product(t16, t169);
    let cylinder_v_y_dot_by_cylinder_x = t156.sub_product(R::literal(3.333_333_333_333_333_5), t171)
        .add_product(t14, t169);
    let cylinder_v_x_dot_by_cylinder_x = t154.sub_product(R::literal(3.333_333_333_333_333_5), t172)
        .sub_product(m.factors[7], t169);
    let plate_omega_dot_by_cylinder_x = (t12 * t173).sub_product(m.factors[60], t174)
        .sub_product(m.factors[60], t172).add_product(t12, t171).add_product(t13, t166)
        .sub_product(m.factors[63], t165);
    let plate_v_y_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t171)
        .add_product(R::literal(-0.833_333_333_333_333_4), t173)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t165);
    let plate_v_x_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t172)
        .add_product(R::literal(-0.833_333_333_333_333_4), t174)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t166);
    let post_omega_dot_by_cylinder_x = (-(t11 * t175).add_product(m.factors[66], t176)
        .add_product(m.factors[66], t174)).add_product(t11, t173);
    let post_v_y_dot_by_cylinder_x = (R::literal(1.25) * t173).add_product(R::literal(1.25), t175);
    let post_v_x_dot_by_cylinder_x = (R::literal(1.25) * t174).add_product(R::literal(-1.25), t176);
    let t177 = R::literal(3.333_333_333_333_333_5) * t62;
    let t178 = t177.sub_product(m.factors[1], t67);
    let t179 = R::literal(3.333_333_333_333_333_5) * t63;
    let t180 = t179.add_product(t15, t67).add_product(t23, t178);
    let t181 = (R::literal(-2_777.777_777_777_778) * t67).add_product(m.factors[5], t178)
        .add_product(m.factors[6], t180);
    let t182 = m.factors[7] * t62;
    let t183 = t14 * t63;
    let t184 = t17 * t62;
    let t185 = m.factors[11] * t63;
    let t186 = ((t182 - t68 - t183).add_product(t16, t67) + t184 - t185).add_product(m.t95, t178)
        .sub_product(m.factors[13], t180).sub_product(t25, t181);
    let t187 = R::literal(5.0) * t62;
    let t188 = (-t187).add_product(m.factors[16], t181).sub_product(m.factors[17], t186);
    let t189 = R::literal(5.0) * t63;
    let t190 = (-t189.add_product(t26, t181)).add_product(m.t133, t186).add_product(m.t144, t188);
    let t191 = (t24 * t178).sub_product(m.factors[23], t180).sub_product(t27, t181)
        .sub_product(m.factors[25], t186).add_product(t29, t188).sub_product(m.factors[27], t190);
    let t192 = (m.t101 * t178).sub_product(m.factors[29], t180).sub_product(t28, t181)
        .sub_product(m.factors[31], t186).add_product(t30, t188).sub_product(m.factors[33], t190)
        .sub_product(m.factors[34], t191) * m.factors[35];
    let t193 = (t191 * m.factors[36]).sub_product(m.factors[34], t192);
    let t194 = (t190 * m.factors[37]).sub_product(m.factors[27], t193).sub_product(m.factors[33],
        t192);
    let t195 = (-(t188 * m.t141)).add_product(m.t144, t194).add_product(t29, t193).add_product(t30,
        t192);
    let t196 = (t186 * m.factors[39]).sub_product(m.factors[17], t195).add_product(m.t133, t194)
        .sub_product(m.factors[25], t193).sub_product(m.factors[31], t192);
    let t197 = (-(t181 * m.factors[40])).add_product(t25, t196).sub_product(m.factors[16], t195)
        .add_product(t26, t194).add_product(t27, t193).add_product(t28, t192);
    let t198 = (t180 * m.factors[41]).sub_product(m.factors[6], t197).sub_product(m.factors[13],
        t196).sub_product(m.factors[23], t193).sub_product(m.factors[29], t192);
    let t199 = (-(t178 * m.t87)).add_product(t23, t198).sub_product(m.factors[5], t197)
        .add_product(m.t95, t196).add_product(t24, t193).add_product(m.t101, t192);
    let t200 = (-(m.factors[44] * t198).add_product(m.factors[43], t199)).add_product(t22, t193)
        .sub_product(m.factors[46], t192);
    let t201 = (-(m.factors[48] * t199).add_product(m.factors[47], t200).add_product(m.factors[49],
        t198).add_product(m.factors[50], t193)).add_product(t21, t192);
    let t202 = (m.factors[53] * t200).add_product(m.factors[52], t201);
    let t203 = (t20 * t201).sub_product(t19, t202).add_product(t19, t200);
    let bobbin_v_y_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t192;
    let bobbin_v_x_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t193;
    let rod_omega_dot_by_cylinder_y = (t18 * t195).sub_product(R::literal(4_166.666_666_666_667),
        t197).sub_product(m.factors[58], t194);
    let rod_v_y_dot_by_cylinder_y = t189.sub_product(m.factors[11], t196)
        .sub_product(R::literal(5.0), t194);
    let rod_v_x_dot_by_cylinder_y = t187.add_product(t17, t196).sub_product(R::literal(5.0), t195);
    let cylinder_omega_dot_by_cylinder_y = (t67 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t199).add_product(t15, t198)
        .sub_product(R::literal(-2_777.777_777_777_778), t197).add_product(t16, t196);
    let cylinder_v_y_dot_by_cylinder_y = (-t179.add_product(R::literal(3.333_333_333_333_333_5),
        t198)).add_product(t14, t196);
    let cylinder_v_x_dot_by_cylinder_y = (-t177).add_product(R::literal(-3.333_333_333_333_333_5),
        t199).sub_product(m.factors[7], t196);
    let plate_omega_dot_by_cylinder_y = (t12 * t200).sub_product(m.factors[60], t201)
        .sub_product(m.factors[60], t199).add_product(t12, t198).add_product(t13, t193)
        .sub_product(m.factors[63], t192);
    let plate_v_y_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t198)
        .add_product(R::literal(-0.833_333_333_333_333_4), t200)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t192);
    let plate_v_x_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t199)
        .add_product(R::literal(-0.833_333_333_333_333_4), t201)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t193);
    let post_omega_dot_by_cylinder_y = (-(t11 * t202).add_product(m.factors[66], t203)
        .add_product(m.factors[66], t201)).add_product(t11, t200);
    let post_v_y_dot_by_cylinder_y = (R::literal(1.25) * t200).add_product(R::literal(1.25), t202);
    let post_v_x_dot_by_cylinder_y = (R::literal(1.25) * t201).add_product(R::literal(-1.25), t203);
    let t204 = R::literal(3.333_333_333_333_333_5) * t74;
    let t205 = ((-(t4 * m.cylinder_omega_dot)).add_product(t73, m.sin_cylinder_phi) - t204)
        .sub_product(m.factors[1], t77);
    let t206 = R::literal(3.333_333_333_333_333_5) * t75;
    let t207 = (-((t5 * m.cylinder_omega_dot).add_product(t73, m.cos_cylinder_phi) + t206))
        .add_product(t15, t77).add_product(t23, t205);
    let t208 = (R::literal(-2_777.777_777_777_778) * t77).add_product(m.factors[5], t205)
        .add_product(m.factors[6], t207);
    let t209 = (-(m.cos_cylinder_phi * m.cylinder_v_x_dot)).add_product(cylinder_omega,
        (t35 * m.sin_cylinder_phi).add_product(t38, m.cos_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, m.cos_cylinder_phi).add_product(cylinder_y * cylinder_omega,
        m.sin_cylinder_phi).sub_product(t36, m.cos_cylinder_phi).sub_product(t37,
        m.sin_cylinder_phi).sub_product(rod_x * cylinder_omega, m.cos_cylinder_phi)
        .sub_product(rod_y * cylinder_omega, m.sin_cylinder_phi)).sub_product(m.sin_cylinder_phi,
        m.cylinder_v_y_dot).sub_product(t76, m.cylinder_omega_dot).add_product(m.cos_cylinder_phi,
        m.rod_v_x_dot).sub_product(m.sin_cylinder_phi, m.t235).sub_product(m.factors[7], t74)
        .add_product(t14, t75).add_product(t16, t77).add_product(t17, t78)
        .sub_product(m.factors[11], t79).add_product(m.t95, t205);
    let t210 = t209.sub_product(m.factors[13], t207).sub_product(t25, t208);
    let t211 = R::literal(5.0) * t78;
    let t212 = (-t211).add_product(m.factors[16], t208).sub_product(m.factors[17], t210);
    let t213 = R::literal(5.0) * t79;
    let t214 = (-t213.add_product(t26, t208)).add_product(m.t133, t210).add_product(m.t144, t212);
    let t215 = (t24 * t205).sub_product(m.factors[23], t207).sub_product(t27, t208)
        .sub_product(m.factors[25], t210).add_product(t29, t212).sub_product(m.factors[27], t214);
    let t216 = (m.t101 * t205).sub_product(m.factors[29], t207).sub_product(t28, t208)
        .sub_product(m.factors[31], t210).add_product(t30, t212).sub_product(m.factors[33], t214)
        .sub_product(m.factors[34], t215) * m.factors[35];
    let t217 = (t215 * m.factors[36]).sub_product(m.factors[34], t216);
    let t218 = (t214 * m.factors[37]).sub_product(m.factors[27], t217).sub_product(m.factors[33],
        t216);
    let t219 = (-(t212 * m.t141)).add_product(m.t144, t218).add_product(t29, t217).add_product(t30,
        t216);
    let t220 = (t210 * m.factors[39]).sub_product(m.factors[17], t219).add_product(m.t133, t218)
        .sub_product(m.factors[25], t217).sub_product(m.factors[31], t216);
    let t221 = (-(t208 * m.factors[40])).add_product(t25, t220).sub_product(m.factors[16], t219)
        .add_product(t26, t218).add_product(t27, t217).add_product(t28, t216);
    let t222 = (t207 * m.factors[41]).sub_product(m.factors[6], t221).sub_product(m.factors[13],
        t220).sub_product(m.factors[23], t217).sub_product(m.factors[29], t216);
    let t223 = (-(t205 * m.t87)).add_product(t23, t222).sub_product(m.factors[5], t221)
        .add_product(m.t95, t220).add_product(t24, t217).add_product(m.t101, t216);
    let t224 = (-(m.factors[44] * t222).add_product(m.factors[43], t223)).add_product(t22, t217)
        .sub_product(m.factors[46], t216);
    let t225 = (-(m.factors[48] * t223).add_product(m.factors[47], t224).add_product(m.factors[49],
        t222).add_product(m.factors[50], t217)).add_product(t21, t216);
    let t226 = (m.factors[53] * t224).add_product(m.factors[52], t225);
    let t227 = (t20 * t225).sub_product(t19, t226).add_product(t19, t224);
    let bobbin_v_y_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t216;
    let bobbin_v_x_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t217;
    let rod_omega_dot_by_cylinder_phi = (t18 * t219).sub_product(R::literal(4_166.666_666_666_667),
        t221).sub_product(m.factors[58], t218);
    let rod_v_y_dot_by_cylinder_phi = t213.sub_product(m.factors[11], t220)
        .sub_product(R::literal(5.0), t218);
    let rod_v_x_dot_by_cylinder_phi = t211.add_product(t17, t220).sub_product(R::literal(5.0),
        t219);
    let cylinder_omega_dot_by_cylinder_phi = (t77 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t223).add_product(t15, t222)
        .sub_product(R::literal(-2_777.777_777_777_778), t221).add_product(t16, t220);
    let cylinder_v_y_dot_by_cylinder_phi = t206.sub_product(R::literal(3.333_333_333_333_333_5),
        t222).add_product(t14, t220);
    let cylinder_v_x_dot_by_cylinder_phi = t204.sub_product(R::literal(3.333_333_333_333_333_5),
        t223).sub_product(m.factors[7], t220);
    let plate_omega_dot_by_cylinder_phi = (t12 * t224).sub_product(m.factors[60], t225)
        .sub_product(m.factors[60], t223).add_product(t12, t222).add_product(t13, t217)
        .sub_product(m.factors[63], t216);
    let plate_v_y_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t222)
        .add_product(R::literal(-0.833_333_333_333_333_4), t224)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t216);
    let plate_v_x_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t223)
        .add_product(R::literal(-0.833_333_333_333_333_4), t225)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t217);
    let post_omega_dot_by_cylinder_phi = (-(t11 * t226).add_product(m.factors[66], t227)
        .add_product(m.factors[66], t225)).add_product(t11, t224);
    let post_v_y_dot_by_cylinder_phi = (R::literal(1.25) * t224).add_product(R::literal(1.25),
        t226);
    let post_v_x_dot_by_cylinder_phi = (R::literal(1.25) * t225).add_product(R::literal(-1.25),
        t227);
    let t228 = R::literal(3.333_333_333_333_333_5) * t56;
    let t229 = t228.add_product(m.factors[1], t80);
    let t230 = R::literal(3.333_333_333_333_333_5) * t57;
    let t231 = (-t230).add_product(t15, t80).sub_product(t23, t229);
    let t232 = (R::literal(2_777.777_777_777_778) * t80).add_product(m.factors[5], t229)
        .sub_product(m.factors[6], t231);
    let t233 = (t60 - t34).sub_product(m.factors[7], t56).add_product(t14, t57).add_product(t16,
        t80).add_product(t17, t49).sub_product(m.factors[11], t50).sub_product(m.t95, t229)
        .sub_product(m.factors[13], t231).add_product(t25, t232);
    let t234 = R::literal(5.0) * t49;
    let t235 = t234.add_product(m.factors[16], t232).add_product(m.factors[17], t233);
    let t236 = R::literal(5.0) * t50;
    let t237 = (-t236).add_product(t26, t232).add_product(m.t133, t233).sub_product(m.t144, t235);
    let t238 = (-(t24 * t229).add_product(m.factors[23], t231)).add_product(t27, t232)
        .sub_product(m.factors[25], t233).sub_product(t29, t235).sub_product(m.factors[27], t237);
    let t239 = (-(m.t101 * t229).add_product(m.factors[29], t231)).add_product(t28, t232)
        .sub_product(m.factors[31], t233).sub_product(t30, t235).sub_product(m.factors[33], t237)
        .sub_product(m.factors[34], t238) * m.factors[35];
    let t240 = (t238 * m.factors[36]).sub_product(m.factors[34], t239);
    let t241 = (t237 * m.factors[37]).sub_product(m.factors[27], t240).sub_product(m.factors[33],
        t239);
    let t242 = (t235 * m.t141).add_product(m.t144, t241).add_product(t29, t240).add_product(t30,
        t239);
    let t243 = (t233 * m.factors[39]).sub_product(m.factors[17], t242).add_product(m.t133, t241)
        .sub_product(m.factors[25], t240).sub_product(m.factors[31], t239);
    let t244 = (t232 * m.factors[40]).add_product(t25, t243).sub_product(m.factors[16], t242)
        .add_product(t26, t241).add_product(t27, t240).add_product(t28, t239);
    let t245 = (t231 * m.factors[41]).sub_product(m.factors[6], t244).sub_product(m.factors[13],
        t243).sub_product(m.factors[23], t240).sub_product(m.factors[29], t239);
    let t246 = (t229 * m.t87).add_product(t23, t245).sub_product(m.factors[5], t244)
        .add_product(m.t95, t243).add_product(t24, t240).add_product(m.t101, t239);
    let t247 = (-(m.factors[44] * t245).add_product(m.factors[43], t246)).add_product(t22, t240)
        .sub_product(m.factors[46], t239);
    let t248 = (-(m.factors[48] * t246).add_product(m.factors[47], t247).add_product(m.factors[49],
        t245).add_product(m.factors[50], t240)).add_product(t21, t239);
    let t249 = (m.factors[53] * t247).add_product(m.factors[52], t248);
    let t250 = (t20 * t248).sub_product(t19, t249).add_product(t19, t247);
    let bobbin_v_y_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t239;
    let bobbin_v_x_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t240;
    let rod_omega_dot_by_rod_x = (t18 * t242).sub_product(R::literal(4_166.666_666_666_667), t244)
        .sub_product(m.factors[58], t241);
    let rod_v_y_dot_by_rod_x = t236.sub_product(m.factors[11], t243).sub_product(R::literal(5.0),
        t241);
    let rod_v_x_dot_by_rod_x = t234.add_product(t17, t243).sub_product(R::literal(5.0), t242);
    let cylinder_omega_dot_by_rod_x = (t80 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t246).add_product(t15, t245)
        .sub_product(R::literal(-2_777.777_777_777_778), t244).add_product(t16, t243);
    let cylinder_v_y_dot_by_rod_x = t230.sub_product(R::literal(3.333_333_333_333_333_5), t245)
        .add_product(t14, t243);
    let cylinder_v_x_dot_by_rod_x = t228.sub_product(R::literal(3.333_333_333_333_333_5), t246)
        .sub_product(m.factors[7], t243);
    let plate_omega_dot_by_rod_x = (t12 * t247).sub_product(m.factors[60], t248)
        .sub_product(m.factors[60], t246).add_product(t12, t245).add_product(t13, t240)
        .sub_product(m.factors[63], t239);
    let plate_v_y_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t245)
        .add_product(R::literal(-0.833_333_333_333_333_4), t247)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t239);
    let plate_v_x_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t246)
        .add_product(R::literal(-0.833_333_333_333_333_4), t248)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t240);
    let post_omega_dot_by_rod_x = (-(t11 * t249).add_product(m.factors[66], t250)
        .add_product(m.factors[66], t248)).add_product(t11, t247);
    let post_v_y_dot_by_rod_x = (R::literal(1.25) * t247).add_product(R::literal(1.25), t249);
    let post_v_x_dot_by_rod_x = (R::literal(1.25) * t248).add_product(R::literal(-1.25), t250);
    let t251 = t177.add_product(m.factors[1], t81);
    let t252 = (-t179).add_product(t15, t81).sub_product(t23, t251);
    let t253 = (R::literal(2_777.777_777_777_778) * t81).add_product(m.factors[5], t251)
        .sub_product(m.factors[6], t252);
    let t254 = ((t68 - t182 + t183).add_product(t16, t81) - t184 + t185).sub_product(m.t95, t251)
        .sub_product(m.factors[13], t252).add_product(t25, t253);
    let t255 = t187.sub_product(m.factors[16], t253).sub_product(m.factors[17], t254);
    let t256 = t189.add_product(t26, t253).add_product(m.t133, t254).add_product(m.t144, t255);
    let t257 = (-(t24 * t251).add_product(m.factors[23], t252)).add_product(t27, t253)
        .sub_product(m.factors[25], t254).add_product(t29, t255).sub_product(m.factors[27], t256);
    let t258 = (-(m.t101 * t251).add_product(m.factors[29], t252)).add_product(t28, t253)
        .sub_product(m.factors[31], t254).add_product(t30, t255).sub_product(m.factors[33], t256)
        .sub_product(m.factors[34], t257) * m.factors[35];
    let t259 = (t257 * m.factors[36]).sub_product(m.factors[34], t258);
    let t260 = (t256 * m.factors[37]).sub_product(m.factors[27], t259).sub_product(m.factors[33],
        t258);
    let t261 = (-(t255 * m.t141)).add_product(m.t144, t260).add_product(t29, t259).add_product(t30,
        t258);
    let t262 = (t254 * m.factors[39]).sub_product(m.factors[17], t261).add_product(m.t133, t260)
        .sub_product(m.factors[25], t259).sub_product(m.factors[31], t258);
    let t263 = (t253 * m.factors[40]).add_product(t25, t262).sub_product(m.factors[16], t261)
        .add_product(t26, t260).add_product(t27, t259).add_product(t28, t258);
    let t264 = (t252 * m.factors[41]).sub_product(m.factors[6], t263).sub_product(m.factors[13],
        t262).sub_product(m.factors[23], t259).sub_product(m.factors[29], t258);
    let t265 = (t251 * m.t87).add_product(t23, t264).sub_product(m.factors[5], t263)
        .add_product(m.t95, t262).add_product(t24, t259).add_product(m.t101, t258);
    let t266 = (-(m.factors[44] * t264).add_product(m.factors[43], t265)).add_product(t22, t259)
        .sub_product(m.factors[46], t258);
    let t267 = (-(m.factors[48] * t265).add_product(m.factors[47], t266).add_product(m.factors[49],
        t264).add_product(m.factors[50], t259)).add_product(t21, t258);
    let t268 = (m.factors[53] * t266).add_product(m.factors[52], t267);
    let t269 = (t20 * t267).sub_product(t19, t268).add_product(t19, t266);
    let bobbin_v_y_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t258;
    let bobbin_v_x_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t259;
    let rod_omega_dot_by_rod_y = (t18 * t261).sub_product(R::literal(4_166.666_666_666_667), t263)
        .sub_product(m.factors[58], t260);
    let rod_v_y_dot_by_rod_y = (-t189.add_product(m.factors[11], t262))
        .add_product(R::literal(-5.0), t260);
    let rod_v_x_dot_by_rod_y = (-t187).add_product(t17, t262).sub_product(R::literal(5.0), t261);
    let cylinder_omega_dot_by_rod_y = (t81 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t265).add_product(t15, t264)
        .sub_product(R::literal(-2_777.777_777_777_778), t263).add_product(t16, t262);
    let cylinder_v_y_dot_by_rod_y = t179.sub_product(R::literal(3.333_333_333_333_333_5), t264)
        .add_product(t14, t262);
    let cylinder_v_x_dot_by_rod_y = t177.sub_product(R::literal(3.333_333_333_333_333_5), t265)
        .sub_product(m.factors[7], t262);
    let plate_omega_dot_by_rod_y = (t12 * t266).sub_product(m.factors[60], t267)
        .sub_product(m.factors[60], t265).add_product(t12, t264).add_product(t13, t259)
        .sub_product(m.factors[63], t258);
    let plate_v_y_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t264)
        .add_product(R::literal(-0.833_333_333_333_333_4), t266)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t258);
    let plate_v_x_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t265)
        .add_product(R::literal(-0.833_333_333_333_333_4), t267)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t259);
    let post_omega_dot_by_rod_y = (-(t11 * t268).add_product(m.factors[66], t269)
        .add_product(m.factors[66], t267)).add_product(t11, t266);
    let post_v_y_dot_by_rod_y = (R::literal(1.25) * t266).add_product(R::literal(1.25), t268);
    let post_v_x_dot_by_rod_y = (R::literal(1.25) * t267).add_product(R::literal(-1.25), t269);
    let t270 = R::literal(4_166.666_666_666_667) * t82;
    let t271 = t25 * t270;
    let t272 = (-m.t188).add_product(t6, m.rod_omega_dot).add_product(t18, t82)
        .add_product(m.factors[16], t270).add_product(m.factors[17], t271);
    let t273 = m.t187.add_product(t7, m.rod_omega_dot).sub_product(m.factors[58], t82)
        .sub_product(t26, t270).sub_product(m.t133, t271).add_product(m.t144, t272);
    let t274 = (-(t27 * t270)).add_product(m.factors[25], t271).add_product(t29, t272)
        .sub_product(m.factors[27], t273);
    let t275 = (-(t28 * t270)).add_product(m.factors[31], t271).add_product(t30, t272)
        .sub_product(m.factors[33], t273).sub_product(m.factors[34], t274) * m.factors[35];
    let t276 = (t274 * m.factors[36]).sub_product(m.factors[34], t275);
    let t277 = (t273 * m.factors[37]).sub_product(m.factors[27], t276).sub_product(m.factors[33],
        t275);
    let t278 = (-(t272 * m.t141)).add_product(m.t144, t277).add_product(t29, t276).add_product(t30,
        t275);
    let t279 = (-(t271 * m.factors[39]).add_product(m.factors[17], t278)).add_product(m.t133, t277)
        .sub_product(m.factors[25], t276).sub_product(m.factors[31], t275);
    let t280 = (-(t270 * m.factors[40])).add_product(t25, t279).sub_product(m.factors[16], t278)
        .add_product(t26, t277).add_product(t27, t276).add_product(t28, t275);
    let t281 = (m.factors[13] * t279).add_product(m.factors[6], t280).add_product(m.factors[23],
        t276).add_product(m.factors[29], t275);
    let t282 = (-(m.factors[5] * t280).add_product(t23, t281)).add_product(m.t95, t279)
        .add_product(t24, t276).add_product(m.t101, t275);
    let t283 = (m.factors[44] * t281).sub_product(m.factors[43], t282).add_product(t22, t276)
        .sub_product(m.factors[46], t275);
    let t284 = (-(m.factors[48] * t282).add_product(m.factors[47], t283))
        .add_product(m.factors[49], t281).sub_product(m.factors[50], t276).add_product(t21, t275);
    let t285 = (m.factors[53] * t283).add_product(m.factors[52], t284);
    let t286 = (t20 * t284).sub_product(t19, t285).add_product(t19, t283);
    let bobbin_v_y_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t275;
    let bobbin_v_x_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t276;
    let rod_omega_dot_by_rod_phi = t270.sub_product(R::literal(4_166.666_666_666_667), t280)
        .add_product(t18, t278).sub_product(m.factors[58], t277);
    let rod_v_y_dot_by_rod_phi = (R::literal(-5.0) * t277).sub_product(m.factors[11], t279);
    let rod_v_x_dot_by_rod_phi = (R::literal(-5.0) * t278).add_product(t17, t279);
    let cylinder_omega_dot_by_rod_phi = (-(t15 * t281).add_product(m.factors[1], t282)
        .add_product(R::literal(-2_777.777_777_777_778), t280)).add_product(t16, t279);
    let cylinder_v_y_dot_by_rod_phi = (t14 * t279).add_product(R::literal(3.333_333_333_333_333_5),
        t281);
    let cylinder_v_x_dot_by_rod_phi = (-(m.factors[7] * t279))
        .add_product(R::literal(-3.333_333_333_333_333_5), t282);
    let plate_omega_dot_by_rod_phi = (t12 * t283).sub_product(m.factors[60], t284)
        .sub_product(m.factors[60], t282).sub_product(t12, t281).add_product(t13, t276)
        .sub_product(m.factors[63], t275);
    let plate_v_y_dot_by_rod_phi = (R::literal(-0.833_333_333_333_333_4) * t281)
        .sub_product(R::literal(0.833_333_333_333_333_4), t283)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t275);
    let plate_v_x_dot_by_rod_phi = (R::literal(0.833_333_333_333_333_4) * t282)
        .add_product(R::literal(-0.833_333_333_333_333_4), t284)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t276);
    let post_omega_dot_by_rod_phi = (-(t11 * t285).add_product(m.factors[66], t286)
        .add_product(m.factors[66], t284)).add_product(t11, t283);
    let post_v_y_dot_by_rod_phi = (R::literal(1.25) * t283).add_product(R::literal(1.25), t285);
    let post_v_x_dot_by_rod_phi = (R::literal(1.25) * t284).add_product(R::literal(-1.25), t286);
    let t287 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t87 * m.t9 / t86 + contact_stiffness_times_contact_gap
        * m.t9 / t86 - contact_damping_times_bobbin_v_x * t8 / t83 - t84 - p.contact_stiffness
        * m.t9 / t83 - t85);
    let t288 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t88 - contact_damping_times_bobbin_v_x * t9 / t83
        - (t90 - t89));
    let t289 = (-t288).add_product(m.factors[34], t287) * m.factors[35];
    let t290 = (t287 * m.factors[36]).add_product(m.factors[34], t289);
    let t291 = (-(m.factors[33] * t289)).add_product(m.factors[27], t290);
    let t292 = (-(t29 * t290)).add_product(m.t144, t291).add_product(t30, t289);
    let t293 = (m.t133 * t291).sub_product(m.factors[17], t292).add_product(m.factors[25], t290)
        .sub_product(m.factors[31], t289);
    let t294 = (-(m.factors[16] * t292)).add_product(t25, t293).add_product(t26, t291)
        .sub_product(t27, t290).add_product(t28, t289);
    let t295 = (-(m.factors[13] * t293).add_product(m.factors[6], t294)).add_product(m.factors[23],
        t290).sub_product(m.factors[29], t289);
    let t296 = (-(m.factors[5] * t294)).add_product(t23, t295).add_product(m.t95, t293)
        .sub_product(t24, t290).add_product(m.t101, t289);
    let t297 = (m.factors[44] * t295).add_product(m.factors[43], t296).add_product(t22, t290)
        .add_product(m.factors[46], t289);
    let t298 = (-(m.factors[48] * t296)).add_product(m.factors[47], t297)
        .sub_product(m.factors[49], t295).add_product(m.factors[50], t290).add_product(t21, t289);
    let t299 = (m.factors[53] * t297).sub_product(m.factors[52], t298);
    let t300 = (t20 * t298).add_product(t19, t299).sub_product(t19, t297);
    let bobbin_v_y_dot_by_bobbin_x = t288.sub_product(R::literal(1.428_571_428_571_428_6), t289);
    let bobbin_v_x_dot_by_bobbin_x = t287.add_product(R::literal(1.428_571_428_571_428_6), t290);
    let rod_omega_dot_by_bobbin_x = (t18 * t292).sub_product(R::literal(4_166.666_666_666_667),
        t294).sub_product(m.factors[58], t291);
    let rod_v_y_dot_by_bobbin_x = (R::literal(-5.0) * t291).sub_product(m.factors[11], t293);
    let rod_v_x_dot_by_bobbin_x = (R::literal(-5.0) * t292).add_product(t17, t293);
    let cylinder_omega_dot_by_bobbin_x = (t15 * t295).sub_product(m.factors[1], t296)
        .sub_product(R::literal(-2_777.777_777_777_778), t294).add_product(t16, t293);
    let cylinder_v_y_dot_by_bobbin_x = (t14 * t293)
        .sub_product(R::literal(3.333_333_333_333_333_5), t295);
    let cylinder_v_x_dot_by_bobbin_x = (-(m.factors[7] * t293))
        .add_product(R::literal(-3.333_333_333_333_333_5), t296);
    let plate_omega_dot_by_bobbin_x = (-(t12 * t297).add_product(m.factors[60], t298)
        .add_product(m.factors[60], t296)).add_product(t12, t295).sub_product(t13, t290)
        .sub_product(m.factors[63], t289);
    let plate_v_y_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t295)
        .add_product(R::literal(0.833_333_333_333_333_4), t297)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t289);
    let plate_v_x_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t296)
        .add_product(R::literal(0.833_333_333_333_333_4), t298))
        .add_product(R::literal(-0.833_333_333_333_333_4), t290);
    let post_omega_dot_by_bobbin_x = (t11 * t299).sub_product(m.factors[66], t300)
        .sub_product(m.factors[66], t298).sub_product(t11, t297);
    let post_v_y_dot_by_bobbin_x = (R::literal(-1.25) * t297).sub_product(R::literal(1.25), t299);
    let post_v_x_dot_by_bobbin_x = (R::literal(1.25) * t298).add_product(R::literal(-1.25), t300);
    let t301 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t88 + t89 - contact_damping_times_bobbin_v_y * t8 / t83
        - t90);
    let t302 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t87 * m.t11 / t86 - contact_damping_times_bobbin_v_y * t9
        / t83 - t85 - (t84 + p.contact_stiffness * m.t11 / t83
        - contact_stiffness_times_contact_gap * m.t11 / t86));
    let t303 = (-t302).add_product(m.factors[34], t301) * m.factors[35];
    let t304 = (t301 * m.factors[36]).add_product(m.factors[34], t303);
    let t305 = (-(m.factors[33] * t303)).add_product(m.factors[27], t304);
    let t306 = (-(t29 * t304)).add_product(m.t144, t305).add_product(t30, t303);
    let t307 = (m.t133 * t305).sub_product(m.factors[17], t306).add_product(m.factors[25], t304)
        .sub_product(m.factors[31], t303);
    let t308 = (-(m.factors[16] * t306)).add_product(t25, t307).add_product(t26, t305)
        .sub_product(t27, t304).add_product(t28, t303);
    let t309 = (-(m.factors[13] * t307).add_product(m.factors[6], t308)).add_product(m.factors[23],
        t304).sub_product(m.factors[29], t303);
    let t310 = (-(m.factors[5] * t308)).add_product(t23, t309).add_product(m.t95, t307)
        .sub_product(t24, t304).add_product(m.t101, t303);
    let t311 = (m.factors[44] * t309).add_product(m.factors[43], t310).add_product(t22, t304)
        .add_product(m.factors[46], t303);
    let t312 = (-(m.factors[48] * t310)).add_product(m.factors[47], t311)
        .sub_product(m.factors[49], t309).add_product(m.factors[50], t304).add_product(t21, t303);
    let t313 = (m.factors[53] * t311).sub_product(m.factors[52], t312);
    let t314 = (t20 * t312).add_product(t19, t313).sub_product(t19, t311);
    let bobbin_v_y_dot_by_bobbin_y = t302.sub_product(R::literal(1.428_571_428_571_428_6), t303);
    let bobbin_v_x_dot_by_bobbin_y = t301.add_product(R::literal(1.428_571_428_571_428_6), t304);
    let rod_omega_dot_by_bobbin_y = (t18 * t306).sub_product(R::literal(4_166.666_666_666_667),
        t308).sub_product(m.factors[58], t305);
    let rod_v_y_dot_by_bobbin_y = (R::literal(-5.0) * t305).sub_product(m.factors[11], t307);
    let rod_v_x_dot_by_bobbin_y = (R::literal(-5.0) * t306).add_product(t17, t307);
    let cylinder_omega_dot_by_bobbin_y = (t15 * t309).sub_product(m.factors[1], t310)
        .sub_product(R::literal(-2_777.777_777_777_778), t308).add_product(t16, t307);
    let cylinder_v_y_dot_by_bobbin_y = (t14 * t307)
        .sub_product(R::literal(3.333_333_333_333_333_5), t309);
    let cylinder_v_x_dot_by_bobbin_y = (-(m.factors[7] * t307))
        .add_product(R::literal(-3.333_333_333_333_333_5), t310);
    let plate_omega_dot_by_bobbin_y = (-(t12 * t311).add_product(m.factors[60], t312)
        .add_product(m.factors[60], t310)).add_product(t12, t309).sub_product(t13, t304)
        .sub_product(m.factors[63], t303);
    let plate_v_y_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t309)
        .add_product(R::literal(0.833_333_333_333_333_4), t311)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t303);
    let plate_v_x_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t310)
        .add_product(R::literal(0.833_333_333_333_333_4), t312))
        .add_product(R::literal(-0.833_333_333_333_333_4), t304);
    let post_omega_dot_by_bobbin_y = (t11 * t313).sub_product(m.factors[66], t314)
        .sub_product(m.factors[66], t312).sub_product(t11, t311);
    let post_v_y_dot_by_bobbin_y = (R::literal(-1.25) * t311).sub_product(R::literal(1.25), t313);
    let post_v_x_dot_by_bobbin_y = (R::literal(1.25) * t312).add_product(R::literal(-1.25), t314);
    let t315 = (t92 * m.cos_post_phi).add_product(m.factors[66], t91);
    let t316 = (-(t92 * m.sin_post_phi)).add_product(t11, t91).sub_product(t19, t315);
    let t317 = t315.add_product(t20, t315).add_product(m.factors[52], t316);
    let t318 = t316.sub_product(m.factors[53], t316).add_product(m.factors[47], t317);
    let t319 = (m.factors[48] * t317).sub_product(m.factors[43], t318);
    let t320 = (m.factors[49] * t317).sub_product(m.factors[44], t318).add_product(t23, t319);
    let t321 = (m.factors[5] * t319).add_product(m.factors[6], t320);
    let t322 = (m.t95 * t319).sub_product(m.factors[13], t320).sub_product(t25, t321);
    let t323 = (m.factors[16] * t321).sub_product(m.factors[17], t322);
    let t324 = (-(t26 * t321)).add_product(m.t133, t322).add_product(m.t144, t323);
    let t325 = (m.factors[50] * t317).add_product(t22, t318).add_product(t24, t319)
        .sub_product(m.factors[23], t320).sub_product(t27, t321).sub_product(m.factors[25], t322)
        .add_product(t29, t323).sub_product(m.factors[27], t324);
    let t326 = (-(t21 * t317).add_product(m.factors[46], t318)).add_product(m.t101, t319)
        .sub_product(m.factors[29], t320).sub_product(t28, t321).sub_product(m.factors[31], t322)
        .add_product(t30, t323).sub_product(m.factors[33], t324).sub_product(m.factors[34], t325)
        * m.factors[35];
    let t327 = (t325 * m.factors[36]).sub_product(m.factors[34], t326);
    let t328 = (t324 * m.factors[37]).sub_product(m.factors[27], t327).sub_product(m.factors[33],
        t326);
    let t329 = (-(t323 * m.t141)).add_product(m.t144, t328).add_product(t29, t327).add_product(t30,
        t326);
    let t330 = (t322 * m.factors[39]).sub_product(m.factors[17], t329).add_product(m.t133, t328)
        .sub_product(m.factors[25], t327).sub_product(m.factors[31], t326);
    let t331 = (-(t321 * m.factors[40])).add_product(t25, t330).sub_product(m.factors[16], t329)
        .add_product(t26, t328).add_product(t27, t327).add_product(t28, t326);
    let t332 = (t320 * m.factors[41]).sub_product(m.factors[6], t331).sub_product(m.factors[13],
        t330).sub_product(m.factors[23], t327).sub_product(m.factors[29], t326);
    let t333 = (-(t319 * m.t87)).add_product(t23, t332).sub_product(m.factors[5], t331)
        .add_product(m.t95, t330).add_product(t24, t327).add_product(m.t101, t326);
    let t334 = (t318 * m.t72).sub_product(m.factors[43], t333).sub_product(m.factors[44], t332)
        .add_product(t22, t327).sub_product(m.factors[46], t326);
    let t335 = (-(t317 * m.t58).add_product(m.factors[47], t334).add_product(m.factors[48], t333)
        .add_product(m.factors[49], t332).add_product(m.factors[50], t327)).add_product(t21, t326);
    let t336 = (t316 * m.t50).sub_product(m.factors[52], t335).sub_product(m.factors[53], t334);
    let t337 = (t315 * m.t40).add_product(t19, t336).add_product(t20, t335).add_product(t19, t334);
    let bobbin_v_y_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t326;
    let bobbin_v_x_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t327;
    let rod_omega_dot_by_post_omega = (t18 * t329).sub_product(R::literal(4_166.666_666_666_667),
        t331).sub_product(m.factors[58], t328);
    let rod_v_y_dot_by_post_omega = (R::literal(-5.0) * t328).sub_product(m.factors[11], t330);
    let rod_v_x_dot_by_post_omega = (R::literal(-5.0) * t329).add_product(t17, t330);
    let cylinder_omega_dot_by_post_omega = (t15 * t332).sub_product(m.factors[1], t333)
        .sub_product(R::literal(-2_777.777_777_777_778), t331).add_product(t16, t330);
    let cylinder_v_y_dot_by_post_omega = (t14 * t330)
        .sub_product(R::literal(3.333_333_333_333_333_5), t332);
    let cylinder_v_x_dot_by_post_omega = (-(m.factors[7] * t330))
        .add_product(R::literal(-3.333_333_333_333_333_5), t333);
    let plate_omega_dot_by_post_omega = (t12 * t334).sub_product(m.factors[60], t335)
        .sub_product(m.factors[60], t333).add_product(t12, t332).add_product(t13, t327)
        .sub_product(m.factors[63], t326);
    let plate_v_y_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t332)
        .add_product(R::literal(-0.833_333_333_333_333_4), t334)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t326);
    let plate_v_x_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t333)
        .add_product(R::literal(-0.833_333_333_333_333_4), t335)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t327);
    let post_omega_dot_by_post_omega = (t91 * R::literal(370.370_370_370_370_3))
        .sub_product(m.factors[66], t337).add_product(t11, t336).sub_product(m.factors[66], t335)
        .add_product(t11, t334);
    let post_v_y_dot_by_post_omega = (R::literal(1.25) * t334).add_product(R::literal(-1.25), t336);
    let post_v_x_dot_by_post_omega = (R::literal(1.25) * t335).add_product(R::literal(-1.25), t337);
    let t338 = (-t95).add_product(m.factors[47], t94);
    let t339 = (-t94).add_product(m.factors[48], t94).sub_product(m.factors[43], t338);
    let t340 = (-t95).add_product(m.factors[49], t94).sub_product(m.factors[44], t338)
        .add_product(t23, t339);
    let t341 = (m.factors[5] * t339).add_product(m.factors[6], t340);
    let t342 = (m.t95 * t339).sub_product(m.factors[13], t340).sub_product(t25, t341);
    let t343 = (m.factors[16] * t341).sub_product(m.factors[17], t342);
    let t344 = (-(t26 * t341)).add_product(m.t133, t342).add_product(m.t144, t343);
    let t345 = (plate_omega * (R::literal(0.02) * m.cos_plate_phi).sub_product(R::literal(0.2),
        m.sin_plate_phi)).add_product(m.factors[50], t94).add_product(t22, t338).add_product(t24,
        t339).sub_product(m.factors[23], t340).sub_product(t27, t341).sub_product(m.factors[25],
        t342).add_product(t29, t343).sub_product(m.factors[27], t344);
    let t346 = (plate_omega * (R::literal(0.02) * m.sin_plate_phi).add_product(R::literal(0.2),
        m.cos_plate_phi)).sub_product(t21, t94).sub_product(m.factors[46], t338)
        .add_product(m.t101, t339).sub_product(m.factors[29], t340).sub_product(t28, t341)
        .sub_product(m.factors[31], t342).add_product(t30, t343).sub_product(m.factors[33], t344)
        .sub_product(m.factors[34], t345) * m.factors[35];
    let t347 = (t345 * m.factors[36]).sub_product(m.factors[34], t346);
    let t348 = (t344 * m.factors[37]).sub_product(m.factors[27], t347).sub_product(m.factors[33],
        t346);
    let t349 = (-(t343 * m.t141)).add_product(m.t144, t348).add_product(t29, t347).add_product(t30,
        t346);
    let t350 = (t342 * m.factors[39]).sub_product(m.factors[17], t349).add_product(m.t133, t348)
        .sub_product(m.factors[25], t347).sub_product(m.factors[31], t346);
    let t351 = (-(t341 * m.factors[40])).add_product(t25, t350).sub_product(m.factors[16], t349)
        .add_product(t26, t348).add_product(t27, t347).add_product(t28, t346);
    let t352 = (t340 * m.factors[41]).sub_product(m.factors[6], t351).sub_product(m.factors[13],
        t350).sub_product(m.factors[23], t347).sub_product(m.factors[29], t346);
    let t353 = (-(t339 * m.t87)).add_product(t23, t352).sub_product(m.factors[5], t351)
        .add_product(m.t95, t350).add_product(t24, t347).add_product(m.t101, t346);
    let t354 = (t338 * m.t72).sub_product(m.factors[43], t353).sub_product(m.factors[44], t352)
        .add_product(t22, t347).sub_product(m.factors[46], t346);
    let t355 = (-(t94 * m.t58).add_product(m.factors[47], t354).add_product(m.factors[48], t353)
        .add_product(m.factors[49], t352).add_product(m.factors[50], t347)).add_product(t21, t346);
    let t356 = (m.factors[53] * t354).add_product(m.factors[52], t355);
    let t357 = (t20 * t355).sub_product(t19, t356).add_product(t19, t354);
    let bobbin_v_y_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t346;
    let bobbin_v_x_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t347;
    let rod_omega_dot_by_plate_omega = (t18 * t349).sub_product(R::literal(4_166.666_666_666_667),
        t351).sub_product(m.factors[58], t348);
    let rod_v_y_dot_by_plate_omega = (R::literal(-5.0) * t348).sub_product(m.factors[11], t350);
    let rod_v_x_dot_by_plate_omega = (R::literal(-5.0) * t349).add_product(t17, t350);
    let cylinder_omega_dot_by_plate_omega = (t15 * t352).sub_product(m.factors[1], t353)
        .sub_product(R::literal(-2_777.777_777_777_778), t351).add_product(t16, t350);
    let cylinder_v_y_dot_by_plate_omega = (t14 * t350)
        .sub_product(R::literal(3.333_333_333_333_333_5), t352);
    let cylinder_v_x_dot_by_plate_omega = (-(m.factors[7] * t350))
        .add_product(R::literal(-3.333_333_333_333_333_5), t353);
    let plate_omega_dot_by_plate_omega = (t12 * t354).sub_product(m.factors[60], t355)
        .sub_product(m.factors[60], t353).add_product(t12, t352).add_product(t13, t347)
        .sub_product(m.factors[63], t346);
    let plate_v_y_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t352)
        .add_product(R::literal(-0.833_333_333_333_333_4), t354)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t346);
    let plate_v_x_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t353)
        .add_product(R::literal(-0.833_333_333_333_333_4), t355)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t347);
    let post_omega_dot_by_plate_omega = (-(t11 * t356).add_product(m.factors[66], t357)
        .add_product(m.factors[66], t355)).add_product(t11, t354);
    let post_v_y_dot_by_plate_omega = (R::literal(1.25) * t354).add_product(R::literal(1.25), t356);
    let post_v_x_dot_by_plate_omega = (R::literal(1.25) * t355).add_product(R::literal(-1.25),
        t357);
    let t358 = R::literal(3.333_333_333_333_333_5) * t96;
    let t359 = m.factors[1] * t99;
    let t360 = t358 - t359;
    let t361 = R::literal(3.333_333_333_333_333_5) * t97;
    let t362 = t361.add_product(t15, t99);
    let t363 = t362.add_product(t23, t360);
    let t364 = R::literal(-2_777.777_777_777_778) * t99;
    let t365 = t364.add_product(m.factors[5], t360).add_product(m.factors[6], t363);
    let t366 = m.factors[7] * t96;
    let t367 = t14 * t97;
    let t368 = t16 * t99;
    let t369 = t17 * t96;
    let t370 = m.factors[11] * t97;
    let t371 = (t366 - t101 - t367 + t368 + t369 - t370).add_product(m.t95, t360)
        .sub_product(m.factors[13], t363).sub_product(t25, t365);
    let t372 = R::literal(5.0) * t96;
    let t373 = (-t372).add_product(m.factors[16], t365).sub_product(m.factors[17], t371);
    let t374 = R::literal(5.0) * t97;
    let t375 = (-t374.add_product(t26, t365)).add_product(m.t133, t371).add_product(m.t144, t373);
    let t376 = (t24 * t360).sub_product(m.factors[23], t363).sub_product(t27, t365)
        .sub_product(m.factors[25], t371).add_product(t29, t373).sub_product(m.factors[27], t375);
    let t377 = (m.t101 * t360).sub_product(m.factors[29], t363).sub_product(t28, t365)
        .sub_product(m.factors[31], t371).add_product(t30, t373).sub_product(m.factors[33], t375)
        .sub_product(m.factors[34], t376) * m.factors[35];
    let t378 = (t376 * m.factors[36]).sub_product(m.factors[34], t377);
    let t379 = (t375 * m.factors[37]).sub_product(m.factors[27], t378).sub_product(m.factors[33],
        t377);
    let t380 = (-(t373 * m.t141)).add_product(m.t144, t379).add_product(t29, t378).add_product(t30,
        t377);
    let t381 = (t371 * m.factors[39]).sub_product(m.factors[17], t380).add_product(m.t133, t379)
        .sub_product(m.factors[25], t378).sub_product(m.factors[31], t377);
    let t382 = (-(t365 * m.factors[40])).add_product(t25, t381).sub_product(m.factors[16], t380)
        .add_product(t26, t379).add_product(t27, t378).add_product(t28, t377);
    let t383 = (t363 * m.factors[41]).sub_product(m.factors[6], t382).sub_product(m.factors[13],
        t381).sub_product(m.factors[23], t378).sub_product(m.factors[29], t377);
    let t384 = (-(t360 * m.t87)).add_product(t23, t383).sub_product(m.factors[5], t382)
        .add_product(m.t95, t381).add_product(t24, t378).add_product(m.t101, t377);
    let t385 = (-(m.factors[44] * t383).add_product(m.factors[43], t384)).add_product(t22, t378)
        .sub_product(m.factors[46], t377);
    let t386 = (-(m.factors[48] * t384).add_product(m.factors[47], t385).add_product(m.factors[49],
        t383).add_product(m.factors[50], t378)).add_product(t21, t377);
    let t387 = (m.factors[53] * t385).add_product(m.factors[52], t386);
    let t388 = (t20 * t386).sub_product(t19, t387).add_product(t19, t385);
    let bobbin_v_y_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t377;
    let bobbin_v_x_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t378;
    let rod_omega_dot_by_cylinder_v_x = (t18 * t380).sub_product(R::literal(4_166.666_666_666_667),
        t382).sub_product(m.factors[58], t379);
    let rod_v_y_dot_by_cylinder_v_x = t374.sub_product(m.factors[11], t381)
        .sub_product(R::literal(5.0), t379);
    let rod_v_x_dot_by_cylinder_v_x = t372.add_product(t17, t381).sub_product(R::literal(5.0),
        t380);
    let t389 = t99 * R::literal(2_777.777_777_777_778);
    let cylinder_omega_dot_by_cylinder_v_x = t389.sub_product(m.factors[1], t384).add_product(t15,
        t383).sub_product(R::literal(-2_777.777_777_777_778), t382).add_product(t16, t381);
    let cylinder_v_y_dot_by_cylinder_v_x = (-t361.add_product(R::literal(3.333_333_333_333_333_5),
        t383)).add_product(t14, t381);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t358)
        .add_product(R::literal(-3.333_333_333_333_333_5), t384).sub_product(m.factors[7], t381);
    let plate_omega_dot_by_cylinder_v_x = (t12 * t385).sub_product(m.factors[60], t386)
        .sub_product(m.factors[60], t384).add_product(t12, t383).add_product(t13, t378)
        .sub_product(m.factors[63], t377);
    let plate_v_y_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t383)
        .add_product(R::literal(-0.833_333_333_333_333_4), t385)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t377);
    let plate_v_x_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t384)
        .add_product(R::literal(-0.833_333_333_333_333_4), t386)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t378);
    let post_omega_dot_by_cylinder_v_x = (-(t11 * t387).add_product(m.factors[66], t388)
        .add_product(m.factors[66], t386)).add_product(t11, t385);
    let post_v_y_dot_by_cylinder_v_x = (R::literal(1.25) * t385).add_product(R::literal(1.25),
        t387);
    let post_v_x_dot_by_cylinder_v_x = (R::literal(1.25) * t386).add_product(R::literal(-1.25),
        t388);
    let t390 = m.factors[1] * t103;
    let t391 = t361 - t390;
    let t392 = R::literal(3.333_333_333_333_333_5) * t102;
    let t393 = t392.add_product(t15, t103);
    let t394 = t393.add_product(t23, t391);
    let t395 = R::literal(-2_777.777_777_777_778) * t103;
    let t396 = t395.add_product(m.factors[5], t391).add_product(m.factors[6], t394);
    let t397 = m.factors[7] * t97;
    let t398 = t14 * t102;
    let t399 = t16 * t103;
    let t400 = t17 * t97;
    let t401 = m.factors[11] * t102;
    let t402 = (t397 - t104 - t398 + t399 + t400 - t401).add_product(m.t95, t391)
        .sub_product(m.factors[13], t394).sub_product(t25, t396);
    let t403 = (-t374).add_product(m.factors[16], t396).sub_product(m.factors[17], t402);
    let t404 = R::literal(5.0) * t102;
    let t405 = (-t404.add_product(t26, t396)).add_product(m.t133, t402).add_product(m.t144, t403);
    let t406 = (t24 * t391).sub_product(m.factors[23], t394).sub_product(t27, t396)
        .sub_product(m.factors[25], t402).add_product(t29, t403).sub_product(m.factors[27], t405);
    let t407 = (m.t101 * t391).sub_product(m.factors[29], t394).sub_product(t28, t396)
        .sub_product(m.factors[31], t402).add_product(t30, t403).sub_product(m.factors[33], t405)
        .sub_product(m.factors[34], t406) * m.factors[35];
    let t408 = (t406 * m.factors[36]).sub_product(m.factors[34], t407);
    let t409 = (t405 * m.factors[37]).sub_product(m.factors[27], t408).sub_product(m.factors[33],
        t407);
    let t410 = (-(t403 * m.t141)).add_product(m.t144, t409).add_product(t29, t408).add_product(t30,
        t407);
    let t411 = (t402 * m.factors[39]).sub_product(m.factors[17], t410).add_product(m.t133, t409)
        .sub_product(m.factors[25], t408).sub_product(m.factors[31], t407);
    let t412 = (-(t396 * m.factors[40])).add_product(t25, t411).sub_product(m.factors[16], t410)
        .add_product(t26, t409).add_product(t27, t408).add_product(t28, t407);
    let t413 = (t394 * m.factors[41]).sub_product(m.factors[6], t412).sub_product(m.factors[13],
        t411).sub_product(m.factors[23], t408).sub_product(m.factors[29], t407);
    let t414 = (-(t391 * m.t87)).add_product(t23, t413).sub_product(m.factors[5], t412)
        .add_product(m.t95, t411).add_product(t24, t408).add_product(m.t101, t407);
    let t415 = (-(m.factors[44] * t413).add_product(m.factors[43], t414)).add_product(t22, t408)
        .sub_product(m.factors[46], t407);
    let t416 = (-(m.factors[48] * t414).add_product(m.factors[47], t415).add_product(m.factors[49],
        t413).add_product(m.factors[50], t408)).add_product(t21, t407);
    let t417 = (m.factors[53] * t415).add_product(m.factors[52], t416);
    let t418 = (t20 * t416).sub_product(t19, t417).add_product(t19, t415);
    let bobbin_v_y_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t407;
    let bobbin_v_x_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t408;
    let rod_omega_dot_by_cylinder_v_y = (t18 * t410).sub_product(R::literal(4_166.666_666_666_667),
        t412).sub_product(m.factors[58], t409);
    let rod_v_y_dot_by_cylinder_v_y = t404.sub_product(m.factors[11], t411)
        .sub_product(R::literal(5.0), t409);
    let rod_v_x_dot_by_cylinder_v_y = t374.add_product(t17, t411).sub_product(R::literal(5.0),
        t410);
    let t419 = t103 * R::literal(2_777.777_777_777_778);
    let cylinder_omega_dot_by_cylinder_v_y = t419.sub_product(m.factors[1], t414).add_product(t15,
        t413).sub_product(R::literal(-2_777.777_777_777_778), t412).add_product(t16, t411);
    let cylinder_v_y_dot_by_cylinder_v_y = (-t392.add_product(R::literal(3.333_333_333_333_333_5),
        t413)).add_product(t14, t411);
    let cylinder_v_x_dot_by_cylinder_v_y = (-t361)
        .add_product(R::literal(-3.333_333_333_333_333_5), t414).sub_product(m.factors[7], t411);
    let plate_omega_dot_by_cylinder_v_y = (t12 * t415).sub_product(m.factors[60], t416)
        .sub_product(m.factors[60], t414).add_product(t12, t413).add_product(t13, t408)
        .sub_product(m.factors[63], t407);
    let plate_v_y_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t413)
        .add_product(R::literal(-0.833_333_333_333_333_4), t415)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t407);
    let plate_v_x_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t414)
        .add_product(R::literal(-0.833_333_333_333_333_4), t416)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t408);
    let post_omega_dot_by_cylinder_v_y = (-(t11 * t417).add_product(m.factors[66], t418)
        .add_product(m.factors[66], t416)).add_product(t11, t415);
    let post_v_y_dot_by_cylinder_v_y = (R::literal(1.25) * t415).add_product(R::literal(1.25),
        t417);
    let post_v_x_dot_by_cylinder_v_y = (R::literal(1.25) * t416).add_product(R::literal(-1.25),
        t418);
    let t420 = R::literal(3.333_333_333_333_333_5) * t99;
    let t421 = (-t420.add_product(t106, m.cos_cylinder_phi)).add_product(m.factors[1], t105);
    let t422 = R::literal(3.333_333_333_333_333_5) * t103;
    let t423 = (-t422.add_product(t106, m.sin_cylinder_phi).add_product(t15, t105))
        .add_product(t23, t421);
    let t424 = (R::literal(-2_777.777_777_777_778) * t105).sub_product(m.factors[5], t421)
        .sub_product(m.factors[6], t423);
    let t425 = (R::literal(2.0) * cylinder_x * cylinder_omega * m.sin_cylinder_phi)
        .add_product(R::literal(2.0) * rod_y * cylinder_omega, m.cos_cylinder_phi).add_product(t37,
        m.cos_cylinder_phi).add_product(t38, m.sin_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_y * cylinder_omega, m.cos_cylinder_phi).sub_product(R::literal(2.0) * rod_x
        * cylinder_omega, m.sin_cylinder_phi).sub_product(t35, m.cos_cylinder_phi).sub_product(t36,
        m.sin_cylinder_phi).sub_product(m.factors[7], t99).add_product(t14, t103).sub_product(t16,
        t105).sub_product(t17, t99).add_product(m.factors[11], t103).add_product(m.t95, t421)
        .sub_product(m.factors[13], t423).add_product(t25, t424);
    let t426 = R::literal(5.0) * t99;
    let t427 = t426.sub_product(m.factors[16], t424).sub_product(m.factors[17], t425);
    let t428 = R::literal(5.0) * t103;
    let t429 = t428.add_product(t26, t424).add_product(m.t133, t425).add_product(m.t144, t427);
    let t430 = (t24 * t421).sub_product(m.factors[23], t423).add_product(t27, t424)
        .sub_product(m.factors[25], t425).add_product(t29, t427).sub_product(m.factors[27], t429);
    let t431 = (m.t101 * t421).sub_product(m.factors[29], t423).add_product(t28, t424)
        .sub_product(m.factors[31], t425).add_product(t30, t427).sub_product(m.factors[33], t429)
        .sub_product(m.factors[34], t430) * m.factors[35];
    let t432 = (t430 * m.factors[36]).sub_product(m.factors[34], t431);
    let t433 = (t429 * m.factors[37]).sub_product(m.factors[27], t432).sub_product(m.factors[33],
        t431);
    let t434 = (-(t427 * m.t141)).add_product(m.t144, t433).add_product(t29, t432).add_product(t30,
        t431);
    let t435 = (t425 * m.factors[39]).sub_product(m.factors[17], t434).add_product(m.t133, t433)
        .sub_product(m.factors[25], t432).sub_product(m.factors[31], t431);
    let t436 = (t424 * m.factors[40]).add_product(t25, t435).sub_product(m.factors[16], t434)
        .add_product(t26, t433).add_product(t27, t432).add_product(t28, t431);
    let t437 = (t423 * m.factors[41]).sub_product(m.factors[6], t436).sub_product(m.factors[13],
        t435).sub_product(m.factors[23], t432).sub_product(m.factors[29], t431);
    let t438 = (-(t421 * m.t87)).add_product(t23, t437).sub_product(m.factors[5], t436)
        .add_product(m.t95, t435).add_product(t24, t432).add_product(m.t101, t431);
    let t439 = (-(m.factors[44] * t437).add_product(m.factors[43], t438)).add_product(t22, t432)
        .sub_product(m.factors[46], t431);
    let t440 = (-(m.factors[48] * t438).add_product(m.factors[47], t439).add_product(m.factors[49],
        t437).add_product(m.factors[50], t432)).add_product(t21, t431);
    let t441 = (m.factors[53] * t439).add_product(m.factors[52], t440);
    let t442 = (t20 * t440).sub_product(t19, t441).add_product(t19, t439);
    let bobbin_v_y_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t431;
    let bobbin_v_x_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t432;
    let rod_omega_dot_by_cylinder_omega = (t18 * t434)
        .sub_product(R::literal(4_166.666_666_666_667), t436).sub_product(m.factors[58], t433);
    let rod_v_y_dot_by_cylinder_omega = (-t428.add_product(m.factors[11], t435))
        .add_product(R::literal(-5.0), t433);
    let rod_v_x_dot_by_cylinder_omega = (-t426).add_product(t17, t435).sub_product(R::literal(5.0),
        t434);
    let cylinder_omega_dot_by_cylinder_omega = (-(t105 * R::literal(2_777.777_777_777_778))
        .add_product(m.factors[1], t438)).add_product(t15, t437)
        .sub_product(R::literal(-2_777.777_777_777_778), t436).add_product(t16, t435);
    let cylinder_v_y_dot_by_cylinder_omega = t422.sub_product(R::literal(3.333_333_333_333_333_5),
        t437).add_product(t14, t435);
    let cylinder_v_x_dot_by_cylinder_omega = t420.sub_product(R::literal(3.333_333_333_333_333_5),
        t438).sub_product(m.factors[7], t435);
    let plate_omega_dot_by_cylinder_omega = (t12 * t439).sub_product(m.factors[60], t440)
        .sub_product(m.factors[60], t438).add_product(t12, t437).add_product(t13, t432)
        .sub_product(m.factors[63], t431);
    let plate_v_y_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t437)
        .add_product(R::literal(-0.833_333_333_333_333_4), t439)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t431);
    let plate_v_x_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t438)
        .add_product(R::literal(-0.833_333_333_333_333_4), t440)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t432);
    let post_omega_dot_by_cylinder_omega = (-(t11 * t441).add_product(m.factors[66], t442)
        .add_product(m.factors[66], t440)).add_product(t11, t439);
    let post_v_y_dot_by_cylinder_omega = (R::literal(1.25) * t439).add_product(R::literal(1.25),
        t441);
    let post_v_x_dot_by_cylinder_omega = (R::literal(1.25) * t440).add_product(R::literal(-1.25),
        t442);
    let t443 = t359 - t358;
    let t444 = (-t362).add_product(t23, t443);
    let t445 = t364.sub_product(m.factors[5], t443).sub_product(m.factors[6], t444);
    let t446 = (t101 - t366 + t367 - t368 - t369 + t370).add_product(m.t95, t443)
        .sub_product(m.factors[13], t444).add_product(t25, t445);
    let t447 = t372.sub_product(m.factors[16], t445).sub_product(m.factors[17], t446);
    let t448 = t374.add_product(t26, t445).add_product(m.t133, t446).add_product(m.t144, t447);
    let t449 = (t24 * t443).sub_product(m.factors[23], t444).add_product(t27, t445)
        .sub_product(m.factors[25], t446).add_product(t29, t447).sub_product(m.factors[27], t448);
    let t450 = (m.t101 * t443).sub_product(m.factors[29], t444).add_product(t28, t445)
        .sub_product(m.factors[31], t446).add_product(t30, t447).sub_product(m.factors[33], t448)
        .sub_product(m.factors[34], t449) * m.factors[35];
    let t451 = (t449 * m.factors[36]).sub_product(m.factors[34], t450);
    let t452 = (t448 * m.factors[37]).sub_product(m.factors[27], t451).sub_product(m.factors[33],
        t450);
    let t453 = (-(t447 * m.t141)).add_product(m.t144, t452).add_product(t29, t451).add_product(t30,
        t450);
    let t454 = (t446 * m.factors[39]).sub_product(m.factors[17], t453).add_product(m.t133, t452)
        .sub_product(m.factors[25], t451).sub_product(m.factors[31], t450);
    let t455 = (t445 * m.factors[40]).add_product(t25, t454).sub_product(m.factors[16], t453)
        .add_product(t26, t452).add_product(t27, t451).add_product(t28, t450);
    let t456 = (t444 * m.factors[41]).sub_product(m.factors[6], t455).sub_product(m.factors[13],
        t454).sub_product(m.factors[23], t451).sub_product(m.factors[29], t450);
    let t457 = (-(t443 * m.t87)).add_product(t23, t456).sub_product(m.factors[5], t455)
        .add_product(m.t95, t454).add_product(t24, t451).add_product(m.t101, t450);
    let t458 = (-(m.factors[44] * t456).add_product(m.factors[43], t457)).add_product(t22, t451)
        .sub_product(m.factors[46], t450);
    let t459 = (-(m.factors[48] * t457).add_product(m.factors[47], t458).add_product(m.factors[49],
        t456).add_product(m.factors[50], t451)).add_product(t21, t450);
    let t460 = (m.factors[53] * t458).add_product(m.factors[52], t459);
    let t461 = (t20 * t459).sub_product(t19, t460).add_product(t19, t458);
    let bobbin_v_y_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t450;
    let bobbin_v_x_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t451;
    let rod_omega_dot_by_rod_v_x = (t18 * t453).sub_product(R::literal(4_166.666_666_666_667), t455)
        .sub_product(m.factors[58], t452);
    let rod_v_y_dot_by_rod_v_x = (-t374.add_product(m.factors[11], t454))
        .add_product(R::literal(-5.0), t452);
    let rod_v_x_dot_by_rod_v_x = (-t372).add_product(t17, t454).sub_product(R::literal(5.0), t453);
    let cylinder_omega_dot_by_rod_v_x = (-t389.add_product(m.factors[1], t457)).add_product(t15,
        t456).sub_product(R::literal(-2_777.777_777_777_778), t455).add_product(t16, t454);
    let cylinder_v_y_dot_by_rod_v_x = t361.sub_product(R::literal(3.333_333_333_333_333_5), t456)
        .add_product(t14, t454);
    let cylinder_v_x_dot_by_rod_v_x = t358.sub_product(R::literal(3.333_333_333_333_333_5), t457)
        .sub_product(m.factors[7], t454);
    let plate_omega_dot_by_rod_v_x = (t12 * t458).sub_product(m.factors[60], t459)
        .sub_product(m.factors[60], t457).add_product(t12, t456).add_product(t13, t451)
        .sub_product(m.factors[63], t450);
    let plate_v_y_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t456)
        .add_product(R::literal(-0.833_333_333_333_333_4), t458)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t450);
    let plate_v_x_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t457)
        .add_product(R::literal(-0.833_333_333_333_333_4), t459)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t451);
    let post_omega_dot_by_rod_v_x = (-(t11 * t460).add_product(m.factors[66], t461)
        .add_product(m.factors[66], t459)).add_product(t11, t458);
    let post_v_y_dot_by_rod_v_x = (R::literal(1.25) * t458).add_product(R::literal(1.25), t460);
    let post_v_x_dot_by_rod_v_x = (R::literal(1.25) * t459).add_product(R::literal(-1.25), t461);
    let t462 = t390 - t361;
    let t463 = (-t393).add_product(t23, t462);
    let t464 = t395.sub_product(m.factors[5], t462).sub_product(m.factors[6], t463);
    let t465 = (t104 - t397 + t398 - t399 - t400 + t401).add_product(m.t95, t462)
        .sub_product(m.factors[13], t463).add_product(t25, t464);
    let t466 = t374.sub_product(m.factors[16], t464).sub_product(m.factors[17], t465);
    let t467 = t404.add_product(t26, t464).add_product(m.t133, t465).add_product(m.t144, t466);
    let t468 = (t24 * t462).sub_product(m.factors[23], t463).add_product(t27, t464)
        .sub_product(m.factors[25], t465).add_product(t29, t466).sub_product(m.factors[27], t467);
    let t469 = (m.t101 * t462).sub_product(m.factors[29], t463).add_product(t28, t464)
        .sub_product(m.factors[31], t465).add_product(t30, t466).sub_product(m.factors[33], t467)
        .sub_product(m.factors[34], t468) * m.factors[35];
    let t470 = (t468 * m.factors[36]).sub_product(m.factors[34], t469);
    let t471 = (t467 * m.factors[37]).sub_product(m.factors[27], t470).sub_product(m.factors[33],
        t469);
    let t472 = (-(t466 * m.t141)).add_product(m.t144, t471).add_product(t29, t470).add_product(t30,
        t469);
    let t473 = (t465 * m.factors[39]).sub_product(m.factors[17], t472).add_product(m.t133, t471)
        .sub_product(m.factors[25], t470).sub_product(m.factors[31], t469);
    let t474 = (t464 * m.factors[40]).add_product(t25, t473).sub_product(m.factors[16], t472)
        .add_product(t26, t471).add_product(t27, t470).add_product(t28, t469);
    let t475 = (t463 * m.factors[41]).sub_product(m.factors[6], t474).sub_product(m.factors[13],
        t473).sub_product(m.factors[23], t470).sub_product(m.factors[29], t469);
    let t476 = (-(t462 * m.t87)).add_product(t23, t475).sub_product(m.factors[5], t474)
        .add_product(m.t95, t473).add_product(t24, t470).add_product(m.t101, t469);
    let t477 = (-(m.factors[44] * t475).add_product(m.factors[43], t476)).add_product(t22, t470)
        .sub_product(m.factors[46], t469);
    let t478 = (-(m.factors[48] * t476).add_product(m.factors[47], t477).add_product(m.factors[49],
        t475).add_product(m.factors[50], t470)).add_product(t21, t469);
    let t479 = (m.factors[53] * t477).add_product(m.factors[52], t478);
    let t480 = (t20 * t478).sub_product(t19, t479).add_product(t19, t477);
    let bobbin_v_y_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t469;
    let bobbin_v_x_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t470;
    let rod_omega_dot_by_rod_v_y = (t18 * t472).sub_product(R::literal(4_166.666_666_666_667), t474)
        .sub_product(m.factors[58], t471);
    let rod_v_y_dot_by_rod_v_y = (-t404.add_product(m.factors[11], t473))
        .add_product(R::literal(-5.0), t471);
    let rod_v_x_dot_by_rod_v_y = (-t374).add_product(t17, t473).sub_product(R::literal(5.0), t472);
    let cylinder_omega_dot_by_rod_v_y = (-t419.add_product(m.factors[1], t476)).add_product(t15,
        t475).sub_product(R::literal(-2_777.777_777_777_778), t474).add_product(t16, t473);
    let cylinder_v_y_dot_by_rod_v_y = t392.sub_product(R::literal(3.333_333_333_333_333_5), t475)
        .add_product(t14, t473);
    let cylinder_v_x_dot_by_rod_v_y = t361.sub_product(R::literal(3.333_333_333_333_333_5), t476)
        .sub_product(m.factors[7], t473);
    let plate_omega_dot_by_rod_v_y = (t12 * t477).sub_product(m.factors[60], t478)
        .sub_product(m.factors[60], t476).add_product(t12, t475).add_product(t13, t470)
        .sub_product(m.factors[63], t469);
    let plate_v_y_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t475)
        .add_product(R::literal(-0.833_333_333_333_333_4), t477)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t469);
    let plate_v_x_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t476)
        .add_product(R::literal(-0.833_333_333_333_333_4), t478)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t470);
    let post_omega_dot_by_rod_v_y = (-(t11 * t479).add_product(m.factors[66], t480)
        .add_product(m.factors[66], t478)).add_product(t11, t477);
    let post_v_y_dot_by_rod_v_y = (R::literal(1.25) * t477).add_product(R::literal(1.25), t479);
    let post_v_x_dot_by_rod_v_y = (R::literal(1.25) * t478).add_product(R::literal(-1.25), t480);
    let t481 = (t107 * m.sin_rod_phi).add_product(m.t144, t108);
    let t482 = (t29 * t108).sub_product(m.factors[27], t481);
    let t483 = (t30 * t108).sub_product(m.factors[33], t481).sub_product(m.factors[34], t482)
        * m.factors[35];
    let t484 = (t482 * m.factors[36]).sub_product(m.factors[34], t483);
    let t485 = (t481 * m.factors[37]).sub_product(m.factors[27], t484).sub_product(m.factors[33],
        t483);
    let t486 = (-(t108 * m.t141)).add_product(m.t144, t485).add_product(t29, t484).add_product(t30,
        t483);
    let t487 = (m.t133 * t485).sub_product(m.factors[17], t486).sub_product(m.factors[25], t484)
        .sub_product(m.factors[31], t483);
    let t488 = (-(m.factors[16] * t486)).add_product(t25, t487).add_product(t26, t485)
        .add_product(t27, t484).add_product(t28, t483);
    let t489 = (m.factors[13] * t487).add_product(m.factors[6], t488).add_product(m.factors[23],
        t484).add_product(m.factors[29], t483);
    let t490 = (-(m.factors[5] * t488).add_product(t23, t489)).add_product(m.t95, t487)
        .add_product(t24, t484).add_product(m.t101, t483);
    let t491 = (m.factors[44] * t489).sub_product(m.factors[43], t490).add_product(t22, t484)
        .sub_product(m.factors[46], t483);
    let t492 = (-(m.factors[48] * t490).add_product(m.factors[47], t491))
        .add_product(m.factors[49], t489).sub_product(m.factors[50], t484).add_product(t21, t483);
    let t493 = (m.factors[53] * t491).add_product(m.factors[52], t492);
    let t494 = (t20 * t492).sub_product(t19, t493).add_product(t19, t491);
    let bobbin_v_y_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t483;
    let bobbin_v_x_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t484;
    let rod_omega_dot_by_rod_omega = (t18 * t486).sub_product(R::literal(4_166.666_666_666_667),
        t488).sub_product(m.factors[58], t485);
    let rod_v_y_dot_by_rod_omega = (R::literal(-5.0) * t485).sub_product(m.factors[11], t487);
    let rod_v_x_dot_by_rod_omega = (R::literal(-5.0) * t486).add_product(t17, t487);
    let cylinder_omega_dot_by_rod_omega = (-(t15 * t489).add_product(m.factors[1], t490)
        .add_product(R::literal(-2_777.777_777_777_778), t488)).add_product(t16, t487);
    let cylinder_v_y_dot_by_rod_omega = (t14 * t487)
        .add_product(R::literal(3.333_333_333_333_333_5), t489);
    let cylinder_v_x_dot_by_rod_omega = (-(m.factors[7] * t487))
        .add_product(R::literal(-3.333_333_333_333_333_5), t490);
    let plate_omega_dot_by_rod_omega = (t12 * t491).sub_product(m.factors[60], t492)
        .sub_product(m.factors[60], t490).sub_product(t12, t489).add_product(t13, t484)
        .sub_product(m.factors[63], t483);
    let plate_v_y_dot_by_rod_omega = (R::literal(-0.833_333_333_333_333_4) * t489)
        .sub_product(R::literal(0.833_333_333_333_333_4), t491)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t483);
    let plate_v_x_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t490)
        .add_product(R::literal(-0.833_333_333_333_333_4), t492)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t484);
    let post_omega_dot_by_rod_omega = (-(t11 * t493).add_product(m.factors[66], t494)
        .add_product(m.factors[66], t492)).add_product(t11, t491);
    let post_v_y_dot_by_rod_omega = (R::literal(1.25) * t491).add_product(R::literal(1.25), t493);
    let post_v_x_dot_by_rod_omega = (R::literal(1.25) * t492).add_product(R::literal(-1.25), t494);
    let t495 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * m.t9 / t83));
    let t496 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * t8 * t9 / t83));
    let t497 = (-t496).add_product(m.factors[34], t495) * m.factors[35];
    let t498 = (t495 * m.factors[36]).add_product(m.factors[34], t497);
    let t499 = (-(m.factors[33] * t497)).add_product(m.factors[27], t498);
    let t500 = (-(t29 * t498)).add_product(m.t144, t499).add_product(t30, t497);
    let t501 = (m.t133 * t499).sub_product(m.factors[17], t500).add_product(m.factors[25], t498)
        .sub_product(m.factors[31], t497);
    let t502 = (-(m.factors[16] * t500)).add_product(t25, t501).add_product(t26, t499)
        .sub_product(t27, t498).add_product(t28, t497);
    let t503 = (-(m.factors[13] * t501).add_product(m.factors[6], t502)).add_product(m.factors[23],
        t498).sub_product(m.factors[29], t497);
    let t504 = (-(m.factors[5] * t502)).add_product(t23, t503).add_product(m.t95, t501)
        .sub_product(t24, t498).add_product(m.t101, t497);
    let t505 = (m.factors[44] * t503).add_product(m.factors[43], t504).add_product(t22, t498)
        .add_product(m.factors[46], t497);
    let t506 = (-(m.factors[48] * t504)).add_product(m.factors[47], t505)
        .sub_product(m.factors[49], t503).add_product(m.factors[50], t498).add_product(t21, t497);
    let t507 = (m.factors[53] * t505).sub_product(m.factors[52], t506);
    let t508 = (t20 * t506).add_product(t19, t507).sub_product(t19, t505);
    let bobbin_v_y_dot_by_bobbin_v_x = t496.sub_product(R::literal(1.428_571_428_571_428_6), t497);
    let bobbin_v_x_dot_by_bobbin_v_x = t495.add_product(R::literal(1.428_571_428_571_428_6), t498);
    let rod_omega_dot_by_bobbin_v_x = (t18 * t500).sub_product(R::literal(4_166.666_666_666_667),
        t502).sub_product(m.factors[58], t499);
    let rod_v_y_dot_by_bobbin_v_x = (R::literal(-5.0) * t499).sub_product(m.factors[11], t501);
    let rod_v_x_dot_by_bobbin_v_x = (R::literal(-5.0) * t500).add_product(t17, t501);
    let cylinder_omega_dot_by_bobbin_v_x = (t15 * t503).sub_product(m.factors[1], t504)
        .sub_product(R::literal(-2_777.777_777_777_778), t502).add_product(t16, t501);
    let cylinder_v_y_dot_by_bobbin_v_x = (t14 * t501)
        .sub_product(R::literal(3.333_333_333_333_333_5), t503);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(m.factors[7] * t501))
        .add_product(R::literal(-3.333_333_333_333_333_5), t504);
    let plate_omega_dot_by_bobbin_v_x = (-(t12 * t505).add_product(m.factors[60], t506)
        .add_product(m.factors[60], t504)).add_product(t12, t503).sub_product(t13, t498)
        .sub_product(m.factors[63], t497);
    let plate_v_y_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t503)
        .add_product(R::literal(0.833_333_333_333_333_4), t505)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t497);
    let plate_v_x_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t504)
        .add_product(R::literal(0.833_333_333_333_333_4), t506))
        .add_product(R::literal(-0.833_333_333_333_333_4), t498);
    let post_omega_dot_by_bobbin_v_x = (t11 * t507).sub_product(m.factors[66], t508)
        .sub_product(m.factors[66], t506).sub_product(t11, t505);
    let post_v_y_dot_by_bobbin_v_x = (R::literal(-1.25) * t505).sub_product(R::literal(1.25), t507);
    let post_v_x_dot_by_bobbin_v_x = (R::literal(1.25) * t506).add_product(R::literal(-1.25), t508);
    let t509 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(p.contact_damping * m.t11 / t83));
    let t510 = (-t509).add_product(m.factors[34], t496) * m.factors[35];
    let t511 = (t496 * m.factors[36]).add_product(m.factors[34], t510);
    let t512 = (-(m.factors[33] * t510)).add_product(m.factors[27], t511);
    let t513 = (-(t29 * t511)).add_product(m.t144, t512).add_product(t30, t510);
    let t514 = (m.t133 * t512).sub_product(m.factors[17], t513).add_product(m.factors[25], t511)
        .sub_product(m.factors[31], t510);
    let t515 = (-(m.factors[16] * t513)).add_product(t25, t514).add_product(t26, t512)
        .sub_product(t27, t511).add_product(t28, t510);
    let t516 = (-(m.factors[13] * t514).add_product(m.factors[6], t515)).add_product(m.factors[23],
        t511).sub_product(m.factors[29], t510);
    let t517 = (-(m.factors[5] * t515)).add_product(t23, t516).add_product(m.t95, t514)
        .sub_product(t24, t511).add_product(m.t101, t510);
    let t518 = (m.factors[44] * t516).add_product(m.factors[43], t517).add_product(t22, t511)
        .add_product(m.factors[46], t510);
    let t519 = (-(m.factors[48] * t517)).add_product(m.factors[47], t518)
        .sub_product(m.factors[49], t516).add_product(m.factors[50], t511).add_product(t21, t510);
    let t520 = (m.factors[53] * t518).sub_product(m.factors[52], t519);
    let t521 = (t20 * t519).add_product(t19, t520).sub_product(t19, t518);
    let bobbin_v_y_dot_by_bobbin_v_y = t509.sub_product(R::literal(1.428_571_428_571_428_6), t510);
    let bobbin_v_x_dot_by_bobbin_v_y = t496.add_product(R::literal(1.428_571_428_571_428_6), t511);
    let rod_omega_dot_by_bobbin_v_y = (t18 * t513).sub_product(R::literal(4_166.666_666_666_667),
        t515).sub_product(m.factors[58], t512);
    let rod_v_y_dot_by_bobbin_v_y = (R::literal(-5.0) * t512).sub_product(m.factors[11], t514);
    let rod_v_x_dot_by_bobbin_v_y = (R::literal(-5.0) * t513).add_product(t17, t514);
    let cylinder_omega_dot_by_bobbin_v_y = (t15 * t516).sub_product(m.factors[1], t517)
        .sub_product(R::literal(-2_777.777_777_777_778), t515).add_product(t16, t514);
    let cylinder_v_y_dot_by_bobbin_v_y = (t14 * t514)
        .sub_product(R::literal(3.333_333_333_333_333_5), t516);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(m.factors[7] * t514))
        .add_product(R::literal(-3.333_333_333_333_333_5), t517);
    let plate_omega_dot_by_bobbin_v_y = (-(t12 * t518).add_product(m.factors[60], t519)
        .add_product(m.factors[60], t517)).add_product(t12, t516).sub_product(t13, t511)
        .sub_product(m.factors[63], t510);
    let plate_v_y_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t516)
        .add_product(R::literal(0.833_333_333_333_333_4), t518)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t510);
    let plate_v_x_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t517)
        .add_product(R::literal(0.833_333_333_333_333_4), t519))
        .add_product(R::literal(-0.833_333_333_333_333_4), t511);
    let post_omega_dot_by_bobbin_v_y = (t11 * t520).sub_product(m.factors[66], t521)
        .sub_product(m.factors[66], t519).sub_product(t11, t518);
    let post_v_y_dot_by_bobbin_v_y = (R::literal(-1.25) * t518).sub_product(R::literal(1.25), t520);
    let post_v_x_dot_by_bobbin_v_y = (R::literal(1.25) * t519).add_product(R::literal(-1.25), t521);
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

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 57 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 56] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _, bobbin_x,
        bobbin_y, _, _, _, _, _, _, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y,
        _, bobbin_v_x, bobbin_v_y, contact_closed, ..] = *state;
    let m = &motion(time, state, p, c);
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

static PARAMETER_JACOBIAN_STEPS: &[Step<'static>] = &[Step::less(18, &[(0, 6), (1, 8)]),
    Step::less(19, &[(0, 7), (2, 8), (3, 18)]), Step::less(20, &[(4, 8), (5, 18), (6, 19)]),
    Step::less(21, &[(7, 6), (8, 7), (9, 8), (10, 9), (11, 10), (12, 18), (13, 19), (14, 20)]),
    Step::less(22, &[(15, 9), (16, 20), (17, 21)]), Step::less(23, &[(15, 10), (18, 20), (19, 21),
    (20, 22)]), Step::less(24, &[(21, 12), (22, 18), (23, 19), (24, 20), (25, 21), (26, 22),
    (27, 23)]), Step::less(25, &[(21, 13), (28, 18), (29, 19), (30, 20), (31, 21), (32, 22),
    (33, 23), (34, 24)]), Step::scaled(25, 35, &[]), Step::scaled(24, 36, &[(34, 25)]),
    Step::scaled(23, 37, &[(27, 24), (33, 25)]), Step::scaled(22, 38, &[(20, 23), (26, 24),
    (32, 25)]), Step::scaled(21, 39, &[(17, 22), (19, 23), (25, 24), (31, 25)]), Step::scaled(20,
    40, &[(14, 21), (16, 22), (18, 23), (24, 24), (30, 25)]), Step::scaled(19, 41,
    &[(6, 20), (13, 21), (23, 24), (29, 25)]), Step::scaled(18, 42, &[(3, 19), (5, 20), (12, 21),
    (22, 24), (28, 25)]), Step::less(17, &[(43, 18), (44, 19), (45, 24), (46, 25)]), Step::less(16,
    &[(47, 17), (48, 18), (49, 19), (50, 24), (51, 25)]), Step::less(15, &[(52, 16), (53, 17)]),
    Step::less(14, &[(54, 15), (55, 16), (54, 17)]), Step::scaled(13, 21, &[(21, 25)]),
    Step::scaled(12, 21, &[(21, 24)]), Step::less(11, &[(56, 20), (57, 22), (58, 23)]),
    Step::scaled(10, 15, &[(11, 21), (15, 23)]), Step::scaled(9, 15, &[(10, 21), (15, 22)]),
    Step::scaled(8, 59, &[(1, 18), (2, 19), (4, 20), (9, 21)]), Step::scaled(7, 0,
    &[(0, 19), (8, 21)]), Step::scaled(6, 0, &[(0, 18), (7, 21)]), Step::less(5,
    &[(60, 16), (61, 17), (60, 18), (61, 19), (62, 24), (63, 25)]), Step::less(4,
    &[(64, 17), (65, 19), (65, 25)]), Step::less(3, &[(64, 16), (65, 18), (65, 24)]), Step::less(2,
    &[(66, 14), (67, 15), (66, 16), (67, 17)]), Step::less(1, &[(68, 15), (69, 17)]), Step::less(0,
    &[(68, 14), (69, 16)])];
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
        .add_product(R::literal(11.772), plate_v_y).sub_product(m.t167, cylinder_v_x)
        .add_product(R::literal(2.943) - m.t169, cylinder_v_y).add_product(m.t172, cylinder_omega)
        .add_product(m.t167, rod_v_x).add_product(R::literal(1.962) + m.t169, rod_v_y)
        .add_product(R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t176),
        bobbin_v_x).add_product(R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5),
        R::literal(0.0), m.t178), bobbin_v_y).sub_product(R::literal(0.8) * post_v_x, m.t240)
        .sub_product(R::literal(0.8) * post_v_y, m.t239).add_product(R::literal(0.0027)
        * post_omega, m.post_omega_dot);
    let t1 = (p.spring_damping * cylinder_omega * m.slide_rate * m.t12)
        .add_product(p.spring_damping * rod_v_x * m.slide_rate, m.cos_cylinder_phi)
        .add_product(p.spring_damping * rod_v_y * m.slide_rate, m.sin_cylinder_phi)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), p.contact_damping
        * bobbin_v_x * m.contact_rate * (bobbin_x - R::literal(0.328)) / m.between
        + p.contact_damping * bobbin_v_y * m.contact_rate * (bobbin_y - R::literal(0.058))
        / m.between);
    PowerBalance {
        stored_rate: t0.sub_product(R::literal(1.2) * plate_v_x, m.t238
            .add_product(R::literal(-0.833_333_333_333_333_4), m.t213)).sub_product(R::literal(1.2)
            * plate_v_y, m.t236 + m.t237).add_product(R::literal(0.0025) * plate_omega,
            m.plate_omega_dot).add_product(R::literal(0.3) * cylinder_v_x, m.cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, m.cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, m.cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, m.rod_v_x_dot).sub_product(R::literal(0.2)
            * rod_v_y, m.t235).add_product(R::literal(0.00024) * rod_omega, m.rod_omega_dot)
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
    let t8 = (R::select_less(t4, contact_push, -t6, m.t177 / t5 - p.contact_damping * bobbin_v_x
        / m.between - t6) * bobbin_v_x).add_product(R::select_less(t4, contact_push, -t7, m.t179
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
