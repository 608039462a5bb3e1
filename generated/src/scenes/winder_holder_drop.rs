// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   8862665d9323a60a12b1825abb2e632fc4b6e54cf82ec877526623a7fbf494e6  scenes/winder_holder_drop.toml
//   9870540d48dd190f3f4e3c2fea172f613c63b75b8e7bdb1d3432a0e230aaf646  units/planar_body.toml
//   c54202922c084fa221d54078498bfb0106d6b12d47343c2f291d70c177b5ce3c  units/spring_damper.toml
//   517928947f958357c2690e0097ee05329d59184bf1a5fe4f24131242e7a636cf  units/one_sided_contact.toml
//
// Four-link bobbin holder, released
//
// The holder of `winder_linkage` with package and post lifted. It falls until the bobbin meets the
// drum and the post its stop, bounces, and settles in its working position. Drum and stop only push:
// both contacts are springs and dampers that open and close by events. The drum stands still; with a
// `grip` it drags the bobbin, P = N f.
//
// Source:
//   Winder study, figures 2 and 3 and its table of links and pairs; every dimension, mass and stiffness is ours.
//
// All quantities are in SI units.
// Shapes: coordinates 14, first-order states 2, states 30, parameters 7, outputs 7, events 4,
//     constraints 12, kinks 2, relations 2.
// Nonzeros: mass_matrix 14 of 14 by 14, rate_jacobian 294 of 30 by 30,
//     parameter_jacobian 70 of 30 by 7, constraint_matrix 37 of 12 by 14.
// Operations: initial_state 1, rate 744, forcing 88, rate_jacobian 4547, parameter_jacobian 86,
//     outputs 52, energy 78, power_balance 124, guards 33, guard_rates 59, constraint_values 49,
//     constraint_rates 63, constraint_matrix 30, kink_guards 28, kink_rates 39, prepare 2,
//     prepared_rate 744, prepared_rate_jacobian 4545, prepared_parameter_jacobian 86, motion 768.

use ::machinist_contract::{Energy, PowerBalance, Real, implicit::{Step, substitute}};

::machinist_contract::simulator! {
    /// Four-link bobbin holder, released
    ///
    /// The holder of \`winder_linkage\` with package and post lifted. It falls until the bobbin meets the
    /// drum and the post its stop, bounces, and settles in its working position. Drum and stop only push:
    /// both contacts are springs and dampers that open and close by events. The drum stands still; with a
    /// \`grip\` it drags the bobbin, P = N f.
    ///
    /// Source: Winder study, figures 2 and 3 and its table of links and pairs; every dimension, mass and stiffness is ours.
    WinderHolderDrop: "winder_holder_drop", "Four-link bobbin holder, released";
    run from 0.0, until 1.0, points 1001, rtol 1e-7, method "auto";
    quadratures 0, discontinuities 0;
    events; constraints; prepared; jacobians_apart; kinks 2; relations;
}

::machinist_contract::parameters! {
    lift: 0.03, "rad", "lift", "initial angle of the post above its stop";
    plate_angle: 1.95, "rad", "plate_angle", "initial angle of the plate";
    grip: 0.0, "1", "grip", "ratio P/N at K: f if the drum turns under the bobbin and drags it to the left, k/R if the bobbin rolls on a drum at rest; below zero to the right";
    spring_stiffness: 2000.0, "N/m", "spring.stiffness", "stiffness of the spring";
    spring_damping: 400.0, "N s/m", "spring.damping", "damping";
    contact_stiffness: 1_000_000.0, "N/m", "contact.stiffness", "stiffness of the contact";
    contact_damping: 1500.0, "N s/m", "contact.damping", "damping of the contact";
    @ held_1: Branch;
    @ held_2: Branch;
}

::machinist_contract::outputs! {
    contact_force: "N", "contact_force", "force of the contact";
    stop_force: "N", "stop_force", "force of the contact";
    contact_gap: "m", "contact_gap", "gap between bobbin and drum at K";
    stop_gap: "m", "stop_gap", "gap between post and stop at T";
    strut_push: "N", "strut_push", "force that pushes the ends apart";
    post_angle: "rad", "post_angle", "angle of the bar from the horizontal";
    plate_angle: "rad", "plate_angle", "angle of the bar from the horizontal";
}

::machinist_contract::states! {
    POST_X: position guess, 0.1, "m", "post.x", "horizontal position of the centre of mass";
    POST_Y: position guess, 0.1, "m", "post.y", "height of the centre of mass";
    POST_PHI: position, 1.0, "rad", "post.phi", "angle of the bar from the horizontal";
    PLATE_X: position guess, 0.1, "m", "plate.x", "horizontal position of the centre of mass";
    PLATE_Y: position guess, 0.1, "m", "plate.y", "height of the centre of mass";
    PLATE_PHI: position, 1.0, "rad", "plate.phi", "angle of the bar from the horizontal";
    CYLINDER_X: position guess, 0.1, "m", "cylinder.x", "horizontal position of the centre of mass";
    CYLINDER_Y: position guess, 0.1, "m", "cylinder.y", "height of the centre of mass";
    CYLINDER_PHI: position guess, 1.0, "rad", "cylinder.phi", "angle of the bar from the horizontal";
    ROD_X: position guess, 0.1, "m", "rod.x", "horizontal position of the centre of mass";
    ROD_Y: position guess, 0.1, "m", "rod.y", "height of the centre of mass";
    ROD_PHI: position guess, 1.0, "rad", "rod.phi", "angle of the bar from the horizontal";
    BOBBIN_X: position guess, 0.1, "m", "bobbin.x", "horizontal position of the centre of mass";
    BOBBIN_Y: position guess, 0.1, "m", "bobbin.y", "height of the centre of mass";
    POST_V_X: velocity guess, 1.0, "m/s", "post.v_x", "rate of horizontal position of the centre of mass";
    POST_V_Y: velocity guess, 1.0, "m/s", "post.v_y", "rate of height of the centre of mass";
    POST_OMEGA: velocity, 10.0, "rad/s", "post.omega", "rate of angle of the bar from the horizontal";
    PLATE_V_X: velocity guess, 1.0, "m/s", "plate.v_x", "rate of horizontal position of the centre of mass";
    PLATE_V_Y: velocity guess, 1.0, "m/s", "plate.v_y", "rate of height of the centre of mass";
    PLATE_OMEGA: velocity, 10.0, "rad/s", "plate.omega", "rate of angle of the bar from the horizontal";
    CYLINDER_V_X: velocity guess, 1.0, "m/s", "cylinder.v_x", "rate of horizontal position of the centre of mass";
    CYLINDER_V_Y: velocity guess, 1.0, "m/s", "cylinder.v_y", "rate of height of the centre of mass";
    CYLINDER_OMEGA: velocity guess, 10.0, "rad/s", "cylinder.omega", "rate of angle of the bar from the horizontal";
    ROD_V_X: velocity guess, 1.0, "m/s", "rod.v_x", "rate of horizontal position of the centre of mass";
    ROD_V_Y: velocity guess, 1.0, "m/s", "rod.v_y", "rate of height of the centre of mass";
    ROD_OMEGA: velocity guess, 10.0, "rad/s", "rod.omega", "rate of angle of the bar from the horizontal";
    BOBBIN_V_X: velocity guess, 1.0, "m/s", "bobbin.v_x", "rate of horizontal position of the centre of mass";
    BOBBIN_V_Y: velocity guess, 1.0, "m/s", "bobbin.v_y", "rate of height of the centre of mass";
    CONTACT_CLOSED: mode, 1.0, "1", "contact.closed", "1 while in contact";
    STOP_CLOSED: mode, 1.0, "1", "stop.closed", "1 while in contact";
}

::machinist_contract::events! {
    "contact.touches": Rising, when [(28, 0.0)], sets [28], "contact begins";
    "contact.opens": Falling, when [(28, 1.0)], sets [28], "the contact would pull";
    "stop.touches": Rising, when [(29, 0.0)], sets [29], "contact begins";
    "stop.opens": Falling, when [(29, 1.0)], sets [29], "the contact would pull";
}

::machinist_contract::constraints! {
    "pin_o_x": of_positions, "m", "pin O in the frame, horizontal";
    "pin_o_y": of_positions, "m", "pin O in the frame, vertical";
    "pin_c_x": of_positions, "m", "pin C of post and plate, horizontal";
    "pin_c_y": of_positions, "m", "pin C of post and plate, vertical";
    "pin_d_x": of_positions, "m", "pin D of plate and cylinder, horizontal";
    "pin_d_y": of_positions, "m", "pin D of plate and cylinder, vertical";
    "slide_angle": of_positions, "1", "S: rod and cylinder are parallel";
    "slide_across": of_positions, "m", "S: rod and cylinder are in line";
    "pin_e_x": of_positions, "m", "pin E in the frame, horizontal";
    "pin_e_y": of_positions, "m", "pin E in the frame, vertical";
    "axle_a_x": of_positions, "m", "axle A of the bobbin on the plate, horizontal";
    "axle_a_y": of_positions, "m", "axle A of the bobbin on the plate, vertical";
}

::machinist_contract::relations! {
    Branch [Event(2), Event(3)];
    Branch [Event(0), Event(1)];
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
    PARAMETER_JACOBIAN_PATTERN: 30 by 7 { 14 [2 3 4 5 6] 15 [2 3 4 5 6] 16 [2 3 4 5 6]
        17 [2 3 4 5 6] 18 [2 3 4 5 6] 19 [2 3 4 5 6] 20 [2 3 4 5 6] 21 [2 3 4 5 6] 22 [2 3 4 5 6]
        23 [2 3 4 5 6] 24 [2 3 4 5 6] 25 [2 3 4 5 6] 26 [2 3 4 5 6] 27 [2 3 4 5 6] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 12 by 14 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6 8]
        5 [4 5 7 8] 6 [8 11] 7 [6 7 8 9 10] 8 [9 11] 9 [10 11] 10 [3 5 12] 11 [4 5 13] }
}

::machinist_contract::constants! {
    t0, grip_times_contact_damping
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 2 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.contact_damping;
    let grip_times_contact_damping = p.grip * p.contact_damping;
    Constants { t0, grip_times_contact_damping }
}

/// What several functions need of the motion; `motion` says what each is.
#[allow(missing_docs, reason = "`motion` says what each is")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    pub factors: [R; 73],
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
    pub t15: R,
    pub t16: R,
    pub t40: R,
    pub t42: R,
    pub t43: R,
    pub t52: R,
    pub t53: R,
    pub t54: R,
    pub t57: R,
    pub t59: R,
    pub t61: R,
    pub t62: R,
    pub t67: R,
    pub t70: R,
    pub t75: R,
    pub t76: R,
    pub t79: R,
    pub t81: R,
    pub t82: R,
    pub t87: R,
    pub t89: R,
    pub t91: R,
    pub t97: R,
    pub t99: R,
    pub t103: R,
    pub t108: R,
    pub t110: R,
    pub t115: R,
    pub t116: R,
    pub t123: R,
    pub t124: R,
    pub t128: R,
    pub t135: R,
    pub t137: R,
    pub t138: R,
    pub t141: R,
    pub t143: R,
    pub t146: R,
    pub t148: R,
    pub t149: R,
    pub t153: R,
    pub t154: R,
    pub t164: R,
    pub t170: R,
    pub t172: R,
    pub t175: R,
    pub t178: R,
    pub t179: R,
    pub t180: R,
    pub t181: R,
    pub t182: R,
    pub t183: R,
    pub t184: R,
    pub t185: R,
    pub t187: R,
    pub t188: R,
    pub t190: R,
    pub t191: R,
    pub t193: R,
    pub t194: R,
    pub t218: R,
    pub t219: R,
    pub t221: R,
    pub t222: R,
    pub t223: R,
    pub t224: R,
    pub t225: R,
    pub t227: R,
    pub t228: R,
    pub t231: R,
    pub t232: R,
    pub t234: R,
    pub t235: R,
    pub t237: R,
    pub t238: R,
    pub t239: R,
    pub t241: R,
    pub t242: R,
    pub bobbin_v_y_dot: R,
    pub bobbin_v_x_dot: R,
    pub rod_omega_dot: R,
    pub t243: R,
    pub rod_v_x_dot: R,
    pub cylinder_omega_dot: R,
    pub cylinder_v_y_dot: R,
    pub cylinder_v_x_dot: R,
    pub plate_omega_dot: R,
    pub t244: R,
    pub t245: R,
    pub t246: R,
    pub post_omega_dot: R,
    pub t247: R,
    pub t248: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions
/// need. 768 operations.
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
    let t13 = contact_stiffness_times_contact_gap + contact_damping_times_contact_rate;
    let t14 = p.grip * t13;
    let t15 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t16 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t17 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t18 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t19 = -t18;
    let t20 = R::literal(24.0) * sin_plate_phi;
    let t21 = R::literal(24.0) * cos_plate_phi;
    let t22 = -t21;
    let t23 = t15 * R::literal(400.0);
    let t24 = -t23;
    let t25 = t16 * R::literal(400.0);
    let t26 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t27 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t28 = -t27;
    let t29 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t30 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t31 = -t30;
    let t32 = slide * R::literal(2_777.777_777_777_778);
    let t33 = -t32;
    let t34 = sin_cylinder_phi * R::literal(5.0);
    let t35 = -t34;
    let t36 = cos_cylinder_phi * R::literal(5.0);
    let t37 = R::literal(250.0) * sin_rod_phi;
    let t38 = -t37;
    let t39 = R::literal(250.0) * cos_rod_phi;
    let t40 = t17 * t1;
    let t41 = R::literal(1.25) + t40;
    let t42 = R::literal(1.0) / t41;
    let t43 = t18 * t1;
    let t44 = t43 * t42;
    let t45 = -t44;
    let t46 = R::literal(1.25) - t40;
    let t47 = t46 * t42;
    let t48 = -t47;
    let t49 = t18 * t0;
    let t50 = R::literal(1.25) + t49;
    let t51 = t44 * t43;
    let t52 = R::literal(1.0) / (t51 - t50);
    let t53 = t17 * t0;
    let t54 = t47 * t43;
    let t55 = t53 + t54;
    let t56 = t55 * t52;
    let t57 = R::literal(1.25) - t49 + t51;
    let t58 = t57 * t52;
    let t59 = t20 * t3;
    let t60 = R::literal(1.0) / (-(t41 + R::literal(0.833_333_333_333_333_4) + t59))
        .add_product(t47, t46).sub_product(t56, t55);
    let t61 = t21 * t3;
    let t62 = (t43 + t61).add_product(t44, t46).sub_product(t58, t55);
    let t63 = t62 * t60;
    let t64 = R::literal(0.833_333_333_333_333_4) - t59;
    let t65 = t64 * t60;
    let t66 = t61 * t60;
    let t67 = t23 * t3;
    let t68 = R::literal(0.833_333_333_333_333_4) + t67;
    let t69 = t68 * t60;
    let t70 = t25 * t3;
    let t71 = t70 * t60;
    let t72 = -t71;
    let t73 = t21 * t2;
    let t74 = R::literal(1.0) / (t51 - (t50 + R::literal(0.833_333_333_333_333_4) + t73))
        .sub_product(t58, t57).sub_product(t63, t62);
    let t75 = t20 * t2;
    let t76 = t65 * t62;
    let t77 = t75 - t76;
    let t78 = t77 * t74;
    let t79 = (R::literal(0.833_333_333_333_333_4) - t73).sub_product(t66, t62);
    let t80 = t79 * t74;
    let t81 = t23 * t2;
    let t82 = t69 * t62;
    let t83 = t81 + t82;
    let t84 = t83 * t74;
    let t85 = -t84;
    let t86 = t25 * t2;
    let t87 = (R::literal(0.833_333_333_333_333_4) + t86).add_product(t71, t62);
    let t88 = t87 * t74;
    let t89 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t59
        + R::literal(3.333_333_333_333_333_5)).add_product(t29, t5).add_product(t65, t64)
        .add_product(t78, t77);
    let t90 = -t89;
    let t91 = t61.add_product(t30, t5).sub_product(t66, t64).sub_product(t80, t77);
    let t92 = t91 * t89;
    let t93 = -t92;
    let t94 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t95 = t94 * t89;
    let t96 = (-t26).add_product(t32, t5);
    let t97 = t96 * t89;
    let t98 = -t97;
    let t99 = (t67 - R::literal(0.833_333_333_333_333_4)).sub_product(t69, t64).add_product(t84,
        t77);
    let t100 = t99 * t89;
    let t101 = -t100;
    let t102 = (-t70).add_product(t71, t64).sub_product(t88, t77);
    let t103 = t102 * t89;
    let t104 = -t103;
    let t105 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t73
        + R::literal(3.333_333_333_333_333_5)).add_product(t30, t4).add_product(t66, t61)
        .add_product(t80, t79)).add_product(t92, t91);
    let t106 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t95, t91);
    let t107 = t106 * t105;
    let t108 = t27.sub_product(t32, t4).add_product(t97, t91);
    let t109 = t108 * t105;
    let t110 = (-t81.add_product(t69, t61)).add_product(t84, t79).add_product(t100, t91);
    let t111 = t110 * t105;
    let t112 = (t86 - R::literal(0.833_333_333_333_333_4)).add_product(t71, t61).sub_product(t88,
        t79).add_product(t103, t91);
    let t113 = t112 * t105;
    let t114 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t95, t94)
        .sub_product(t107, t106);
    let t115 = t32.add_product(t97, t94);
    let t116 = t109 * t106;
    let t117 = t115 + t116;
    let t118 = t117 * t114;
    let t119 = -t118;
    let t120 = t37 * t114;
    let t121 = t39 * t114;
    let t122 = -t121;
    let t123 = t100 * t94;
    let t124 = t111 * t106;
    let t125 = t123 + t124;
    let t126 = t125 * t114;
    let t127 = -t126;
    let t128 = (t103 * t94).add_product(t113, t106);
    let t129 = t128 * t114;
    let t130 = -t129;
    let t131 = R::literal(1.0) / (-(t26 * sin_cylinder_phi).add_product(t27, cos_cylinder_phi)
        .add_product(t32, slide).add_product(t34, sin_cylinder_phi).add_product(t36,
        cos_cylinder_phi)).add_product(t97, t96).sub_product(t109, t108).sub_product(t118, t117);
    let t132 = t34.add_product(t120, t117);
    let t133 = t132 * t131;
    let t134 = t36.add_product(t121, t117);
    let t135 = t134 * t131;
    let t136 = -t135;
    let t137 = (t100 * t96).sub_product(t111, t108);
    let t138 = t126 * t117;
    let t139 = t137 - t138;
    let t140 = t139 * t131;
    let t141 = (t103 * t96).sub_product(t113, t108).sub_product(t129, t117);
    let t142 = t141 * t131;
    let t143 = R::literal(1.0) / R::literal(5.0).add_product(t37, t6).add_product(t120, t37)
        .add_product(t133, t132);
    let t144 = -t143;
    let t145 = (t39 * t6).add_product(t121, t37).add_product(t135, t132);
    let t146 = t145 * t143;
    let t147 = -t146;
    let t148 = t126 * t37;
    let t149 = t140 * t132;
    let t150 = t148 - t149;
    let t151 = t150 * t143;
    let t152 = -t151;
    let t153 = t129 * t37;
    let t154 = t142 * t132;
    let t155 = t153 - t154;
    let t156 = t155 * t143;
    let t157 = -t156;
    let t158 = R::literal(1.0) / (-R::literal(5.0).add_product(t39, R::literal(0.06) * cos_rod_phi)
        .add_product(t121, t39).add_product(t135, t134)).add_product(t146, t145);
    let t159 = (-(t126 * t39)).add_product(t140, t134).add_product(t151, t145);
    let t160 = t159 * t158;
    let t161 = (-(t129 * t39)).add_product(t142, t134).add_product(t156, t145);
    let t162 = t161 * t158;
    let t163 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t23, t15)
        + R::literal(1.428_571_428_571_428_6)).add_product(t69, t68).add_product(t84, t83))
        .add_product(t100, t99).sub_product(t111, t110).sub_product(t126, t125).sub_product(t140,
        t139).add_product(t151, t150).sub_product(t160, t159);
    let t164 = (t25 * t15).add_product(t71, t68).add_product(t88, t83).add_product(t103, t99)
        .sub_product(t113, t110).sub_product(t129, t125).sub_product(t142, t139).add_product(t156,
        t150).sub_product(t162, t159);
    let t165 = t164 * t163;
    let t166 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t25, t16)
        + R::literal(1.428_571_428_571_428_6)).add_product(t71, t70).add_product(t88, t87))
        .add_product(t103, t102).sub_product(t113, t112).sub_product(t129, t128).sub_product(t142,
        t141).add_product(t156, t155).sub_product(t162, t161).sub_product(t165, t164);
    let t167 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t7).add_product(R::literal(1500.0) * stop_rate, t7));
    let t168 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t14
        * (between - R::literal(0.04)));
    let t169 = p.spring_stiffness * (slide - R::literal(0.116));
    let t170 = t169 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t171 = t170.add_product(spring_damping_times_slide_rate, cos_cylinder_phi);
    let t172 = t169 * sin_cylinder_phi;
    let t173 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t174 = t173 - (R::literal(2.943) - t172);
    let t175 = t169 * t12;
    let t176 = t175.add_product(spring_damping_times_slide_rate, t12);
    let t177 = t173 + (R::literal(1.962) + t172);
    let t178 = t14 * t10 / between;
    let t179 = contact_stiffness_times_contact_gap * t8;
    let t180 = t179 / between;
    let t181 = contact_damping_times_contact_rate * t8;
    let t182 = contact_stiffness_times_contact_gap * t10 / between;
    let t183 = contact_damping_times_contact_rate * t10;
    let t184 = t14 * t8;
    let t185 = t184 / between;
    let t186 = R::literal(0.1) * (post_omega * post_omega);
    let t187 = t186 * cos_post_phi;
    let t188 = t186 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t189 = R::literal(0.06) * plate_omega_squared;
    let t190 = t189 * cos_plate_phi;
    let t191 = t189 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t192 = R::literal(0.06) * (rod_omega * rod_omega);
    let t193 = t192 * cos_rod_phi;
    let t194 = t192 * sin_rod_phi;
    let t195 = t17 * t167;
    let t196 = t187 + t195;
    let t197 = t18 * t167;
    let t198 = t44 * t196;
    let t199 = R::literal(9.81) - t188 + t197 - t198;
    let t200 = t20 * t168;
    let t201 = (t190 + t187 + t195 + t200).add_product(t47, t196).add_product(t56, t199);
    let t202 = t21 * t168;
    let t203 = (t197 - (t191 + t188 + R::literal(9.81)) + R::literal(9.81) + t202 - t198)
        .sub_product(t58, t199).add_product(t63, t201);
    let t204 = R::literal(3.333_333_333_333_333_5) * t171;
    let t205 = (-(t200.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) + t204)).add_product(t29, t176)
        .add_product(t65, t201).sub_product(t78, t203);
    let t206 = R::literal(3.333_333_333_333_333_5) * t174;
    let t207 = (t202 - R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) - t206)
        .sub_product(t30, t176).add_product(t66, t201).sub_product(t80, t203).add_product(t92,
        t205);
    let t208 = (R::literal(-2_777.777_777_777_778) * t176).sub_product(t95, t205).sub_product(t107,
        t207);
    let t209 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t26, t171)
        .add_product(t27, t174).sub_product(t32, t176).sub_product(t34, t171).add_product(t36, t177)
        .add_product(t97, t205).sub_product(t109, t207);
    let t210 = t209.add_product(t118, t208);
    let t211 = R::literal(5.0) * t171;
    let t212 = (t193 + t211).sub_product(t120, t208).sub_product(t133, t210);
    let t213 = R::literal(5.0) * t177;
    let t214 = (t194 + t213).add_product(t121, t208).add_product(t135, t210).add_product(t146,
        t212);
    let t215 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t178 - t180 - t181 / between);
    let t216 = ((t16 * plate_omega_squared).add_product(t23, t168) - t215).add_product(t69, t201)
        .add_product(t84, t203).add_product(t100, t205).sub_product(t111, t207).add_product(t126,
        t208).sub_product(t140, t210).add_product(t151, t212).sub_product(t160, t214);
    let t217 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t185 + t183 / between)) - (R::literal(6.867)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t182)));
    let t218 = (R::literal(-9.81).add_product(t15, plate_omega_squared).sub_product(t25, t168)
        - t217).sub_product(t71, t201).sub_product(t88, t203).add_product(t103, t205)
        .sub_product(t113, t207).add_product(t129, t208).sub_product(t142, t210).add_product(t156,
        t212).sub_product(t162, t214);
    let t219 = t165 * t216;
    let t220 = (t218 - t219) * t166;
    let t221 = (t216 * t163).sub_product(t165, t220);
    let t222 = (t214 * t158).sub_product(t160, t221).sub_product(t162, t220);
    let t223 = (-(t212 * t143)).add_product(t146, t222);
    let t224 = t151 * t221;
    let t225 = t156 * t220;
    let t226 = t223 + t224 + t225;
    let t227 = (t210 * t131).sub_product(t133, t226).add_product(t135, t222).sub_product(t140,
        t221);
    let t228 = t142 * t220;
    let t229 = t227 - t228;
    let t230 = (t208 * t114).add_product(t118, t229).sub_product(t120, t226).add_product(t121, t222)
        .add_product(t126, t221).add_product(t129, t220);
    let t231 = (t207 * t105).sub_product(t107, t230).sub_product(t109, t229).sub_product(t111,
        t221);
    let t232 = t113 * t220;
    let t233 = t231 - t232;
    let t234 = (-(t205 * t89)).add_product(t92, t233).sub_product(t95, t230).add_product(t97, t229)
        .add_product(t100, t221);
    let t235 = t103 * t220;
    let t236 = t234 + t235;
    let t237 = (t203 * t74).sub_product(t78, t236).sub_product(t80, t233).add_product(t84, t221)
        .sub_product(t88, t220);
    let t238 = (t201 * t60).add_product(t63, t237).add_product(t65, t236).add_product(t66, t233)
        .add_product(t69, t221);
    let t239 = t71 * t220;
    let t240 = t239 - t238;
    let t241 = (t199 * t52).sub_product(t56, t240).sub_product(t58, t237);
    let t242 = (t196 * t42).add_product(t44, t241).add_product(t47, t240).add_product(t44, t237);
    let bobbin_v_y_dot = t217.sub_product(R::literal(1.428_571_428_571_428_6), t220);
    let bobbin_v_x_dot = t215.sub_product(R::literal(1.428_571_428_571_428_6), t221);
    let rod_omega_dot = (t37 * t226).sub_product(R::literal(4_166.666_666_666_667), t230)
        .sub_product(t39, t222);
    let t243 = t213.add_product(t36, t229).add_product(R::literal(5.0), t222);
    let rod_v_x_dot = (-t211).add_product(t34, t229).sub_product(R::literal(5.0), t226);
    let cylinder_omega_dot = (-(t176 * R::literal(2_777.777_777_777_778)).add_product(t29, t236))
        .add_product(t30, t233).sub_product(R::literal(-2_777.777_777_777_778), t230)
        .add_product(t32, t229);
    let cylinder_v_y_dot = t206.sub_product(R::literal(3.333_333_333_333_333_5), t233)
        .add_product(t27, t229);
    let cylinder_v_x_dot = t204.sub_product(R::literal(3.333_333_333_333_333_5), t236)
        .sub_product(t26, t229);
    let plate_omega_dot = (t168 * R::literal(400.0)).sub_product(t20, t240).add_product(t21, t237)
        .sub_product(t20, t236).add_product(t21, t233).add_product(t23, t221).sub_product(t25,
        t220);
    let t244 = R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t237)
        .add_product(R::literal(-0.833_333_333_333_333_4), t233);
    let t245 = R::literal(-0.833_333_333_333_333_4) * t220;
    let t246 = (R::literal(-0.833_333_333_333_333_4) * t236)
        .add_product(R::literal(0.833_333_333_333_333_4), t240);
    let post_omega_dot = (t167 * R::literal(370.370_370_370_370_3)).sub_product(t17, t242)
        .add_product(t18, t241).sub_product(t17, t240).add_product(t18, t237);
    let t247 = R::literal(9.81).add_product(R::literal(1.25), t241).add_product(R::literal(-1.25),
        t237);
    let t248 = (R::literal(-1.25) * t240).add_product(R::literal(1.25), t242);
    Motion {
        factors: [t20, t22, t63, R::literal(3.333_333_333_333_333_5), t29, t65, t78, t31, t66, t80,
            t93, R::literal(-2_777.777_777_777_778), t95, t107, t26, t28, t33, t35, t36, t98, t109,
            t119, R::literal(5.0), t120, t133, t122, t136, t147, t24,
            R::literal(1.428_571_428_571_428_6), t69, t85, t101, t111, t127, t140, t152, t160, t25,
            t72, t88, t104, t113, t130, t142, t157, t162, t165, t166, t163, t158, t144, t131, t114,
            t105, t90, t74, t60, t56, t58, t45, t48, R::literal(4_166.666_666_666_667), t38, t39,
            R::literal(2_777.777_777_777_778), R::literal(400.0),
            R::literal(0.833_333_333_333_333_4), R::literal(-0.833_333_333_333_333_4), t17, t19,
            R::literal(1.25), R::literal(-1.25)],
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
        t15,
        t16,
        t40,
        t42,
        t43,
        t52,
        t53,
        t54,
        t57,
        t59,
        t61,
        t62,
        t67,
        t70,
        t75,
        t76,
        t79,
        t81,
        t82,
        t87,
        t89,
        t91,
        t97,
        t99,
        t103,
        t108,
        t110,
        t115,
        t116,
        t123,
        t124,
        t128,
        t135,
        t137,
        t138,
        t141,
        t143,
        t146,
        t148,
        t149,
        t153,
        t154,
        t164,
        t170,
        t172,
        t175,
        t178,
        t179,
        t180,
        t181,
        t182,
        t183,
        t184,
        t185,
        t187,
        t188,
        t190,
        t191,
        t193,
        t194,
        t218,
        t219,
        t221,
        t222,
        t223,
        t224,
        t225,
        t227,
        t228,
        t231,
        t232,
        t234,
        t235,
        t237,
        t238,
        t239,
        t241,
        t242,
        bobbin_v_y_dot,
        bobbin_v_x_dot,
        rod_omega_dot,
        t243,
        rod_v_x_dot,
        cylinder_omega_dot,
        cylinder_v_y_dot,
        cylinder_v_x_dot,
        plate_omega_dot,
        t244,
        t245,
        t246,
        post_omega_dot,
        t247,
        t248,
    }
}

/// State at the start of the run, in the units of the states. 1 operation.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.096), R::literal(0.03), p.lift + R::literal(0.298_498_931_586_179_3),
        R::literal(0.172), R::literal(0.116), p.plate_angle, R::literal(0.103), R::literal(0.207),
        R::literal(2.53), R::literal(0.049), R::literal(0.245), R::literal(2.53),
        R::literal(0.269), R::literal(0.139), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 744 operations.
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
    let t11 = p.grip * (contact_stiffness_times_contact_gap + contact_damping_times_contact_rate);
    let t12 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t13 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let t14 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t15 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t16 = R::literal(24.0) * sin_plate_phi;
    let t17 = R::literal(24.0) * cos_plate_phi;
    let t18 = t12 * R::literal(400.0);
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
    let t72 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t73 = t72 * t69;
    let t74 = (-t20).add_product(t24, t5);
    let t75 = t74 * t69;
    let t76 = (t52 - R::literal(0.833_333_333_333_333_4)).sub_product(t54, t49).add_product(t65,
        t59);
    let t77 = t76 * t69;
    let t78 = (-t55).add_product(t56, t49).sub_product(t68, t59);
    let t79 = t78 * t69;
    let t80 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t57
        + R::literal(3.333_333_333_333_333_5)).add_product(t23, t4).add_product(t51, t46)
        .add_product(t62, t61)).add_product(t71, t70);
    let t81 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t73, t70);
    let t82 = t81 * t80;
    let t83 = t21.sub_product(t24, t4).add_product(t75, t70);
    let t84 = t83 * t80;
    let t85 = (-t63.add_product(t54, t46)).add_product(t65, t61).add_product(t77, t70);
    let t86 = t85 * t80;
    let t87 = (t66 - R::literal(0.833_333_333_333_333_4)).add_product(t56, t46).sub_product(t68,
        t61).add_product(t79, t70);
    let t88 = t87 * t80;
    let t89 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t73, t72)
        .sub_product(t82, t81);
    let t90 = t24.add_product(t75, t72).add_product(t84, t81);
    let t91 = t90 * t89;
    let t92 = t27 * t89;
    let t93 = t28 * t89;
    let t94 = (t77 * t72).add_product(t86, t81);
    let t95 = t94 * t89;
    let t96 = (t79 * t72).add_product(t88, t81);
    let t97 = t96 * t89;
    let t98 = R::literal(1.0) / (-(t20 * sin_cylinder_phi).add_product(t21, cos_cylinder_phi)
        .add_product(t24, slide).add_product(t25, sin_cylinder_phi).add_product(t26,
        cos_cylinder_phi)).add_product(t75, t74).sub_product(t84, t83).sub_product(t91, t90);
    let t99 = t25.add_product(t92, t90);
    let t100 = t99 * t98;
    let t101 = t26.add_product(t93, t90);
    let t102 = t101 * t98;
    let t103 = (t77 * t74).sub_product(t86, t83).sub_product(t95, t90);
    let t104 = t103 * t98;
    let t105 = (t79 * t74).sub_product(t88, t83).sub_product(t97, t90);
    let t106 = t105 * t98;
    let t107 = R::literal(1.0) / R::literal(5.0).add_product(t27, t6).add_product(t92, t27)
        .add_product(t100, t99);
    let t108 = (t28 * t6).add_product(t93, t27).add_product(t102, t99);
    let t109 = t108 * t107;
    let t110 = (t95 * t27).sub_product(t104, t99);
    let t111 = t110 * t107;
    let t112 = (t97 * t27).sub_product(t106, t99);
    let t113 = t112 * t107;
    let t114 = R::literal(1.0) / (-R::literal(5.0).add_product(t28, R::literal(0.06) * cos_rod_phi)
        .add_product(t93, t28).add_product(t102, t101)).add_product(t109, t108);
    let t115 = (-(t95 * t28)).add_product(t104, t101).add_product(t111, t108);
    let t116 = t115 * t114;
    let t117 = (-(t97 * t28)).add_product(t106, t101).add_product(t113, t108);
    let t118 = t117 * t114;
    let t119 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t12)
        + R::literal(1.428_571_428_571_428_6)).add_product(t54, t53).add_product(t65, t64))
        .add_product(t77, t76).sub_product(t86, t85).sub_product(t95, t94).sub_product(t104, t103)
        .add_product(t111, t110).sub_product(t116, t115);
    let t120 = (t19 * t12).add_product(t56, t53).add_product(t68, t64).add_product(t79, t76)
        .sub_product(t88, t85).sub_product(t97, t94).sub_product(t106, t103).add_product(t113, t110)
        .sub_product(t118, t115);
    let t121 = t120 * t119;
    let t122 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t19, t13)
        + R::literal(1.428_571_428_571_428_6)).add_product(t56, t55).add_product(t68, t67))
        .add_product(t79, t78).sub_product(t88, t87).sub_product(t97, t96).sub_product(t106, t105)
        .add_product(t113, t112).sub_product(t118, t117).sub_product(t121, t120);
    let t123 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (R::literal(-1_000_000.0) * stop_gap * t7).sub_product(R::literal(1500.0) * stop_rate, t7));
    let t124 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t11
        * (between - R::literal(0.04)));
    let t125 = p.spring_stiffness * (slide - R::literal(0.116));
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t126 = (t125 * cos_cylinder_phi).add_product(spring_damping_times_slide_rate,
        cos_cylinder_phi);
    let t127 = t125 * sin_cylinder_phi;
    let t128 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t129 = t128 - (R::literal(2.943) - t127);
    let t130 = (t125 * t10).add_product(spring_damping_times_slide_rate, t10);
    let t131 = t128 + (R::literal(1.962) + t127);
    let t132 = R::literal(0.1) * (post_omega * post_omega);
    let t133 = t132 * cos_post_phi;
    let t134 = t132 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t135 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t136 = R::literal(0.06) * (rod_omega * rod_omega);
    let t137 = t14 * t123;
    let t138 = t133 + t137;
    let t139 = t15 * t123;
    let t140 = t33 * t138;
    let t141 = R::literal(9.81) - t134 + t139 - t140;
    let t142 = t16 * t124;
    let t143 = (t133.add_product(t135, cos_plate_phi) + t137 + t142).add_product(t35, t138)
        .add_product(t41, t141);
    let t144 = t17 * t124;
    let t145 = (t139 - (t134.add_product(t135, sin_plate_phi) + R::literal(9.81))
        + R::literal(9.81) + t144 - t140).sub_product(t43, t141).add_product(t48, t143);
    let t146 = R::literal(3.333_333_333_333_333_5) * t126;
    let t147 = (-(t142.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) + t146)).add_product(t22, t130)
        .add_product(t50, t143).sub_product(t60, t145);
    let t148 = R::literal(3.333_333_333_333_333_5) * t129;
    let t149 = (t144 - R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) - t148)
        .sub_product(t23, t130).add_product(t51, t143).sub_product(t62, t145).add_product(t71,
        t147);
    let t150 = (R::literal(-2_777.777_777_777_778) * t130).sub_product(t73, t147).sub_product(t82,
        t149);
    let t151 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t20, t126)
        .add_product(t21, t129).sub_product(t24, t130).sub_product(t25, t126).add_product(t26, t131)
        .add_product(t75, t147).sub_product(t84, t149);
    let t152 = t151.add_product(t91, t150);
    let t153 = R::literal(5.0) * t126;
    let t154 = t153.add_product(t136, cos_rod_phi).sub_product(t92, t150).sub_product(t100, t152);
    let t155 = R::literal(5.0) * t131;
    let t156 = t155.add_product(t136, sin_rod_phi).add_product(t93, t150).add_product(t102, t152)
        .add_product(t109, t154);
    let t157 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t11 * t9 / between - contact_stiffness_times_contact_gap
        * t8 / between - contact_damping_times_contact_rate * t8 / between);
    let t158 = ((t13 * plate_omega_squared).add_product(t18, t124) - t157).add_product(t54, t143)
        .add_product(t65, t145).add_product(t77, t147).sub_product(t86, t149).add_product(t95, t150)
        .sub_product(t104, t152).add_product(t111, t154).sub_product(t116, t156);
    let t159 = R::literal(1.428_571_428_571_428_6) * (R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t11 * t8 / between + contact_damping_times_contact_rate
        * t9 / between)) - (R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5),
        R::literal(0.0), contact_stiffness_times_contact_gap * t9 / between)));
    let t160 = (R::literal(-9.81).add_product(t12, plate_omega_squared).sub_product(t19, t124)
        - t159).sub_product(t56, t143).sub_product(t68, t145).add_product(t79, t147)
        .sub_product(t88, t149).add_product(t97, t150).sub_product(t106, t152).add_product(t113,
        t154).sub_product(t118, t156).sub_product(t121, t158) * t122;
    let t161 = (t158 * t119).sub_product(t121, t160);
    let t162 = (t156 * t114).sub_product(t116, t161).sub_product(t118, t160);
    let t163 = (-(t154 * t107)).add_product(t109, t162).add_product(t111, t161).add_product(t113,
        t160);
    let t164 = (t152 * t98).sub_product(t100, t163).add_product(t102, t162).sub_product(t104, t161)
        .sub_product(t106, t160);
    let t165 = (t150 * t89).add_product(t91, t164).sub_product(t92, t163).add_product(t93, t162)
        .add_product(t95, t161).add_product(t97, t160);
    let t166 = (t149 * t80).sub_product(t82, t165).sub_product(t84, t164).sub_product(t86, t161)
        .sub_product(t88, t160);
    let t167 = (-(t147 * t69)).add_product(t71, t166).sub_product(t73, t165).add_product(t75, t164)
        .add_product(t77, t161).add_product(t79, t160);
    let t168 = (t145 * t58).sub_product(t60, t167).sub_product(t62, t166).add_product(t65, t161)
        .sub_product(t68, t160);
    let t169 = (-(t143 * t45).add_product(t48, t168).add_product(t50, t167).add_product(t51, t166)
        .add_product(t54, t161)).add_product(t56, t160);
    let t170 = (t141 * t39).sub_product(t41, t169).sub_product(t43, t168);
    let t171 = (t138 * t31).add_product(t33, t170).add_product(t35, t169).add_product(t33, t168);
    let bobbin_v_y_dot = t159.sub_product(R::literal(1.428_571_428_571_428_6), t160);
    let bobbin_v_x_dot = t157.sub_product(R::literal(1.428_571_428_571_428_6), t161);
    let rod_omega_dot = (t27 * t163).sub_product(R::literal(4_166.666_666_666_667), t165)
        .sub_product(t28, t162);
    let rod_v_y_dot = (-t155.add_product(t26, t164)).add_product(R::literal(-5.0), t162);
    let rod_v_x_dot = (-t153).add_product(t25, t164).sub_product(R::literal(5.0), t163);
    let cylinder_omega_dot = (-(t130 * R::literal(2_777.777_777_777_778)).add_product(t22, t167))
        .add_product(t23, t166).sub_product(R::literal(-2_777.777_777_777_778), t165)
        .add_product(t24, t164);
    let cylinder_v_y_dot = t148.sub_product(R::literal(3.333_333_333_333_333_5), t166)
        .add_product(t21, t164);
    let cylinder_v_x_dot = t146.sub_product(R::literal(3.333_333_333_333_333_5), t167)
        .sub_product(t20, t164);
    let plate_omega_dot = (t124 * R::literal(400.0)).sub_product(t16, t169).add_product(t17, t168)
        .sub_product(t16, t167).add_product(t17, t166).add_product(t18, t161).sub_product(t19,
        t160);
    let plate_v_y_dot = R::literal(-9.81).sub_product(R::literal(0.833_333_333_333_333_4), t168)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t166)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t160);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t167)
        .add_product(R::literal(-0.833_333_333_333_333_4), t169)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t161);
    let post_omega_dot = (t123 * R::literal(370.370_370_370_370_3)).sub_product(t14, t171)
        .add_product(t15, t170).sub_product(t14, t169).add_product(t15, t168);
    let post_v_y_dot = R::literal(-9.81).sub_product(R::literal(1.25), t170)
        .sub_product(R::literal(-1.25), t168);
    let post_v_x_dot = (R::literal(1.25) * t169).add_product(R::literal(-1.25), t171);
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

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 88 operations.
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
    let t4 = p.grip * (contact_stiffness_times_contact_gap + contact_damping_times_contact_rate);
    let post_phi_forcing = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (R::literal(-1_000_000.0) * stop_gap * t0).sub_product(R::literal(1500.0) * stop_rate, t0));
    let plate_phi_forcing = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t4
        * (between - R::literal(0.04)));
    let t5 = p.spring_stiffness * (slide - R::literal(0.116));
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let cylinder_x_forcing = (t5 * cos_cylinder_phi).add_product(spring_damping_times_slide_rate,
        cos_cylinder_phi);
    let t6 = t5 * sin_cylinder_phi;
    let t7 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let cylinder_y_forcing = t7 - (R::literal(2.943) - t6);
    let cylinder_phi_forcing = -(t5 * t3).add_product(spring_damping_times_slide_rate, t3);
    let rod_x_forcing = -cylinder_x_forcing;
    let rod_y_forcing = R::literal(-1.962) - t6 - t7;
    let bobbin_x_forcing = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t4 * t2
        / between - contact_stiffness_times_contact_gap * t1 / between
        - contact_damping_times_contact_rate * t1 / between);
    let bobbin_y_forcing = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(t4 * t1 / between + contact_damping_times_contact_rate * t2 / between))
        - (R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        contact_stiffness_times_contact_gap * t2 / between));
    [R::literal(0.0), R::literal(-7.848), post_phi_forcing, R::literal(0.0), R::literal(-11.772),
        plate_phi_forcing, cylinder_x_forcing, cylinder_y_forcing, cylinder_phi_forcing,
        rod_x_forcing, rod_y_forcing, R::literal(0.0), bobbin_x_forcing, bobbin_y_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 4545 operations.
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
    let t10 = p.grip * m.t13;
    let t11 = (R::literal(0.1) * m.sin_plate_phi).sub_product(R::literal(0.01), m.cos_plate_phi);
    let t12 = R::literal(37.037_037_037_037_03) * m.cos_post_phi;
    let t13 = R::literal(24.0) * m.cos_plate_phi;
    let t14 = m.t15 * R::literal(400.0);
    let t15 = m.cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t16 = R::literal(166.666_666_666_666_66) * m.cos_cylinder_phi;
    let t17 = m.slide * R::literal(2_777.777_777_777_778);
    let t18 = m.sin_cylinder_phi * R::literal(5.0);
    let t19 = R::literal(250.0) * m.sin_rod_phi;
    let t20 = m.t43 * m.t42;
    let t21 = (R::literal(1.25) - m.t40) * m.t42;
    let t22 = m.t70 * m.factors[57];
    let t23 = (m.t81 + m.t82) * m.factors[56];
    let t24 = m.t91 * m.t89;
    let t25 = m.t99 * m.t89;
    let t26 = (m.t115 + m.t116) * m.factors[53];
    let t27 = m.factors[64] * m.factors[53];
    let t28 = (m.t123 + m.t124) * m.factors[53];
    let t29 = m.t128 * m.factors[53];
    let t30 = (m.t148 - m.t149) * m.t143;
    let t31 = (m.t153 - m.t154) * m.t143;
    let t32 = m.between - R::literal(0.04);
    let t33 = p.spring_damping * m.slide_rate;
    let t34 = t33 * m.cos_cylinder_phi;
    let t35 = t33 * m.sin_cylinder_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t36 = cylinder_omega_squared * m.sin_cylinder_phi;
    let t37 = R::literal(2.0) * cylinder_v_x;
    let t38 = R::literal(2.0) * cylinder_v_y;
    let t39 = R::literal(2.0) * rod_v_x;
    let t40 = R::literal(2.0) * rod_v_y;
    let t41 = m.t227 - m.t228;
    let t42 = m.t231 - m.t232;
    let t43 = m.t234 + m.t235;
    let t44 = m.t239 - m.t238;
    let t45 = m.t7 * m.t7;
    let t46 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), (R::literal(3000.0)
        * m.stop_gap * stop_rate).add_product(R::literal(1_000_000.0), m.stop_gap * m.stop_gap)
        .sub_product(R::literal(1_000_000.0), t45)).sub_product(t0, m.t242).sub_product(t1, m.t241)
        .sub_product(t0, t44).sub_product(t1, m.t237);
    let t47 = (-(t2 * t44).add_product(t3, m.t237).add_product(t2, t43).add_product(t3, t42)
        .add_product(t11, m.t221)).add_product(m.t15, (m.t218 - m.t219) * m.factors[48]);
    let t48 = p.spring_stiffness * m.cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t49 = spring_damping_times_cylinder_omega * m.sin_cylinder_phi;
    let t50 = t49 - t48;
    let t51 = t50 * m.cos_cylinder_phi;
    let t52 = t50 * m.sin_cylinder_phi;
    let t53 = spring_damping_times_cylinder_omega * m.t12;
    let t54 = t53 * m.sin_cylinder_phi;
    let t55 = p.spring_stiffness * m.t12;
    let t56 = t55 * m.cos_cylinder_phi;
    let t57 = t48 - t49;
    let t58 = t57 * m.cos_cylinder_phi;
    let t59 = t57 * m.sin_cylinder_phi;
    let t60 = m.cos_cylinder_phi * t41;
    let t61 = t56 - t54 - m.t172 - t35 - t60;
    let t62 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t63 = (p.spring_stiffness * m.sin_cylinder_phi)
        .add_product(spring_damping_times_cylinder_omega, m.cos_cylinder_phi);
    let t64 = t63 * m.cos_cylinder_phi;
    let t65 = t63 * m.sin_cylinder_phi;
    let t66 = t55 * m.sin_cylinder_phi;
    let t67 = m.t170.add_product(t53, m.cos_cylinder_phi) + t66 + t34;
    let t68 = m.sin_cylinder_phi * t41;
    let t69 = t67 - t68;
    let t70 = (m.sin_cylinder_phi * m.cylinder_omega_dot).add_product(cylinder_omega_squared,
        m.cos_cylinder_phi);
    let t71 = p.spring_damping * (-(cylinder_omega * m.slide)).add_product(rod_v_y - cylinder_v_y,
        m.cos_cylinder_phi).sub_product(rod_v_x - cylinder_v_x, m.sin_cylinder_phi);
    let t72 = t71 * m.cos_cylinder_phi;
    let t73 = t34.add_product(t71, m.sin_cylinder_phi) + (m.t170 + t66);
    let t74 = m.t12 * m.t12;
    let t75 = R::literal(0.06) * cylinder_omega_squared;
    let t76 = t56 + t72 - m.t172 - t35 - t60;
    let t77 = t73 - t68;
    let t78 = ((rod_x - cylinder_x) * m.sin_cylinder_phi).sub_product(rod_y - cylinder_y,
        m.cos_cylinder_phi);
    let t79 = (p.spring_stiffness * m.slide * (m.slide - R::literal(0.116)))
        .add_product(p.spring_damping * m.slide, m.slide_rate).sub_product(p.spring_stiffness, t74)
        .sub_product(t71, m.t12).sub_product(t4, t43).sub_product(t5, t42).sub_product(t78, t41);
    let t80 = m.t172 + t35 - t56 - t72 + t60;
    let t81 = t68 - t73;
    let t82 = t54 + m.t172 + t35 - t56 + t60;
    let t83 = t68 - t67;
    let t84 = (t7 * m.t222).add_product(t6, m.t223 + m.t224 + m.t225);
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t85 = p.contact_stiffness * t8;
    let t86 = m.between * m.between;
    let t87 = m.t181 / t86 - contact_damping_times_bobbin_v_x / m.between - t85 / m.between;
    let t88 = p.grip * t32;
    let t89 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t185
        .sub_product(t88, t87));
    let t90 = p.grip * t9;
    let t91 = contact_stiffness_times_contact_gap / m.between;
    let t92 = p.contact_damping * m.contact_rate / m.between;
    let t93 = t86 * m.between;
    let t94 = c.t0 * m.contact_rate;
    let t95 = m.t184 * t9 / t93;
    let t96 = t94 * t8 * t9 / t93;
    let t97 = t10 / m.between;
    let t98 = p.grip * t8;
    let t99 = m.t179 * t9 / t93;
    let t100 = t85 * t9 / t86;
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t101 = m.t183 / t86 - contact_damping_times_bobbin_v_y / m.between - p.contact_stiffness
        * t9 / m.between;
    let t102 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t178
        .sub_product(t88, t101));
    let t103 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(-1500.0)
        * t45);
    let t104 = R::literal(0.2) * post_omega;
    let t105 = R::literal(0.12) * plate_omega;
    let t106 = t105 * m.cos_plate_phi;
    let t107 = t105 * m.sin_plate_phi;
    let t108 = p.spring_damping * (m.cos_cylinder_phi * m.cos_cylinder_phi);
    let t109 = p.spring_damping * m.sin_cylinder_phi * m.cos_cylinder_phi;
    let t110 = p.spring_damping * m.t12;
    let t111 = t110 * m.cos_cylinder_phi;
    let t112 = R::literal(2.0) * cylinder_omega;
    let t113 = t112 * m.cos_cylinder_phi;
    let t114 = p.spring_damping * (m.sin_cylinder_phi * m.sin_cylinder_phi);
    let t115 = t110 * m.sin_cylinder_phi;
    let t116 = t112 * m.sin_cylinder_phi;
    let t117 = p.spring_damping * t74;
    let t118 = R::literal(0.12) * cylinder_omega;
    let t119 = R::literal(0.12) * rod_omega;
    let t120 = t119 * m.cos_rod_phi;
    let t121 = c.grip_times_contact_damping * t8;
    let t122 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t121 * t32
        / m.between);
    let t123 = t121 * t9 / t86;
    let t124 = p.contact_damping * t8 * t9 / t86;
    let t125 = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        c.grip_times_contact_damping * t9 * t32 / m.between);
    let t126 = m.t188.sub_product(t0, m.post_omega_dot).sub_product(m.factors[69], t46);
    let t127 = (-m.t187.add_product(t1, m.post_omega_dot)).add_product(t12, t46).add_product(t20,
        t126);
    let t128 = t126.add_product(t21, t126).sub_product(m.factors[58], t127);
    let t129 = t127.sub_product(m.factors[59], t127).sub_product(m.factors[2], t128);
    let t130 = (m.factors[5] * t128).add_product(m.factors[6], t129);
    let t131 = (m.factors[8] * t128).add_product(m.factors[9], t129).add_product(t24, t130);
    let t132 = (m.factors[12] * t130).add_product(m.factors[13], t131);
    let t133 = (-(m.t97 * t130)).add_product(m.factors[20], t131).add_product(t26, t132);
    let t134 = (m.factors[23] * t132).add_product(m.factors[24], t133);
    let t135 = (t27 * t132).add_product(m.t135, t133).sub_product(m.t146, t134);
    let t136 = (-(m.factors[30] * t128)).add_product(t23, t129).sub_product(t25, t130)
        .add_product(m.factors[33], t131).add_product(t28, t132).sub_product(m.factors[35], t133)
        .sub_product(t30, t134).sub_product(m.factors[37], t135);
    let t137 = (t22 * t128).sub_product(m.factors[40], t129).sub_product(m.t103, t130)
        .add_product(m.factors[42], t131).add_product(t29, t132).sub_product(m.factors[44], t133)
        .sub_product(t31, t134).sub_product(m.factors[46], t135).sub_product(m.factors[47], t136)
        * m.factors[48];
    let t138 = (t136 * m.factors[49]).sub_product(m.factors[47], t137);
    let t139 = (t135 * m.factors[50]).sub_product(m.factors[37], t138).sub_product(m.factors[46],
        t137);
    let t140 = (t134 * m.t143).add_product(m.t146, t139).add_product(t30, t138).add_product(t31,
        t137);
    let t141 = (t133 * m.factors[52]).sub_product(m.factors[24], t140).add_product(m.t135, t139)
        .sub_product(m.factors[35], t138).sub_product(m.factors[44], t137);
    let t142 = (t132 * m.factors[53]).add_product(t26, t141).sub_product(m.factors[23], t140)
        .add_product(t27, t139).add_product(t28, t138).add_product(t29, t137);
    let t143 = (t131 * m.factors[54]).add_product(m.factors[13], t142).add_product(m.factors[20],
        t141).add_product(m.factors[33], t138).add_product(m.factors[42], t137);
    let t144 = (t130 * m.t89).sub_product(t24, t143).sub_product(m.factors[12], t142)
        .add_product(m.t97, t141).add_product(t25, t138).add_product(m.t103, t137);
    let t145 = (t129 * m.factors[56]).sub_product(m.factors[6], t144).add_product(m.factors[9],
        t143).add_product(t23, t138).sub_product(m.factors[40], t137);
    let t146 = (t128 * m.factors[57]).sub_product(m.factors[2], t145).sub_product(m.factors[5],
        t144).add_product(m.factors[8], t143).sub_product(m.factors[30], t138).add_product(t22,
        t137);
    let t147 = (t127 * m.t52).sub_product(m.factors[58], t146).sub_product(m.factors[59], t145);
    let t148 = (-(t126 * m.t42)).add_product(t20, t147).add_product(t21, t146).add_product(t20,
        t145);
    let bobbin_v_y_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t137;
    let bobbin_v_x_dot_by_post_phi = R::literal(-1.428_571_428_571_428_6) * t138;
    let rod_omega_dot_by_post_phi = (t19 * t140).sub_product(R::literal(4_166.666_666_666_667),
        t142).sub_product(m.factors[64], t139);
    let rod_v_y_dot_by_post_phi = (R::literal(-5.0) * t139).sub_product(m.factors[18], t141);
    let rod_v_x_dot_by_post_phi = (R::literal(-5.0) * t140).add_product(t18, t141);
    let cylinder_omega_dot_by_post_phi = (-(t16 * t143).add_product(m.factors[4], t144)
        .add_product(R::literal(-2_777.777_777_777_778), t142)).add_product(t17, t141);
    let cylinder_v_y_dot_by_post_phi = (t15 * t141)
        .add_product(R::literal(3.333_333_333_333_333_5), t143);
    let cylinder_v_x_dot_by_post_phi = (-(m.factors[14] * t141))
        .add_product(R::literal(-3.333_333_333_333_333_5), t144);
    let plate_omega_dot_by_post_phi = (t13 * t145).sub_product(m.factors[0], t146)
        .sub_product(m.factors[0], t144).sub_product(t13, t143).add_product(t14, t138)
        .sub_product(m.factors[38], t137);
    let plate_v_y_dot_by_post_phi = (R::literal(-0.833_333_333_333_333_4) * t143)
        .sub_product(R::literal(0.833_333_333_333_333_4), t145)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t137);
    let plate_v_x_dot_by_post_phi = (R::literal(0.833_333_333_333_333_4) * t144)
        .add_product(R::literal(-0.833_333_333_333_333_4), t146)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t138);
    let post_omega_dot_by_post_phi = (t46 * R::literal(370.370_370_370_370_3))
        .sub_product(m.factors[69], t148).add_product(t12, t147).sub_product(m.factors[69], t146)
        .add_product(t12, t145);
    let post_v_y_dot_by_post_phi = (R::literal(1.25) * t145).add_product(R::literal(-1.25), t147);
    let post_v_x_dot_by_post_phi = (R::literal(1.25) * t146).add_product(R::literal(-1.25), t148);
    let t149 = m.t191.sub_product(t2, m.plate_omega_dot).sub_product(m.factors[0], t47);
    let t150 = (-m.t190.add_product(t3, m.plate_omega_dot)).add_product(t13, t47);
    let t151 = t150.sub_product(m.factors[2], t149);
    let t152 = t149.sub_product(m.factors[5], t149).sub_product(m.factors[6], t151);
    let t153 = t150.sub_product(m.factors[8], t149).sub_product(m.factors[9], t151)
        .add_product(t24, t152);
    let t154 = (m.factors[12] * t152).add_product(m.factors[13], t153);
    let t155 = (m.t97 * t152).sub_product(m.factors[20], t153).sub_product(t26, t154);
    let t156 = (m.factors[23] * t154).sub_product(m.factors[24], t155);
    let t157 = (-(t27 * t154)).add_product(m.t135, t155).add_product(m.t146, t156);
    let t158 = (-(m.t15 * plate_omega_squared).add_product(t11, m.plate_omega_dot))
        .add_product(t14, t47).sub_product(m.factors[30], t149).add_product(t23, t151)
        .add_product(t25, t152).sub_product(m.factors[33], t153).sub_product(t28, t154)
        .sub_product(m.factors[35], t155).add_product(t30, t156).sub_product(m.factors[37], t157);
    let t159 = (m.t15 * m.plate_omega_dot).add_product(m.t16, plate_omega_squared)
        .sub_product(m.factors[38], t47).add_product(t22, t149).sub_product(m.factors[40], t151)
        .add_product(m.t103, t152).sub_product(m.factors[42], t153).sub_product(t29, t154)
        .sub_product(m.factors[44], t155).add_product(t31, t156).sub_product(m.factors[46], t157)
        .sub_product(m.factors[47], t158) * m.factors[48];
    let t160 = (t158 * m.factors[49]).sub_product(m.factors[47], t159);
    let t161 = (t157 * m.factors[50]).sub_product(m.factors[37], t160).sub_product(m.factors[46],
        t159);
    let t162 = (-(t156 * m.t143)).add_product(m.t146, t161).add_product(t30, t160).add_product(t31,
        t159);
    let t163 = (t155 * m.factors[52]).sub_product(m.factors[24], t162).add_product(m.t135, t161)
        .sub_product(m.factors[35], t160).sub_product(m.factors[44], t159);
    let t164 = (-(t154 * m.factors[53])).add_product(t26, t163).sub_product(m.factors[23], t162)
        .add_product(t27, t161).add_product(t28, t160).add_product(t29, t159);
    let t165 = (t153 * m.factors[54]).sub_product(m.factors[13], t164).sub_product(m.factors[20],
        t163).sub_product(m.factors[33], t160).sub_product(m.factors[42], t159);
    let t166 = (-(t152 * m.t89)).add_product(t24, t165).sub_product(m.factors[12], t164)
        .add_product(m.t97, t163).add_product(t25, t160).add_product(m.t103, t159);
    let t167 = (t151 * m.factors[56]).sub_product(m.factors[6], t166).sub_product(m.factors[9],
        t165).add_product(t23, t160).sub_product(m.factors[40], t159);
    let t168 = (t149 * m.factors[57]).sub_product(m.factors[2], t167).sub_product(m.factors[5],
        t166).sub_product(m.factors[8], t165).sub_product(m.factors[30], t160).add_product(t22,
        t159);
    let t169 = (m.factors[59] * t167).add_product(m.factors[58], t168);
    let t170 = (t21 * t168).sub_product(t20, t169).add_product(t20, t167);
    let bobbin_v_y_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t159;
    let bobbin_v_x_dot_by_plate_phi = R::literal(-1.428_571_428_571_428_6) * t160;
    let rod_omega_dot_by_plate_phi = (t19 * t162).sub_product(R::literal(4_166.666_666_666_667),
        t164).sub_product(m.factors[64], t161);
    let rod_v_y_dot_by_plate_phi = (R::literal(-5.0) * t161).sub_product(m.factors[18], t163);
    let rod_v_x_dot_by_plate_phi = (R::literal(-5.0) * t162).add_product(t18, t163);
    let cylinder_omega_dot_by_plate_phi = (t16 * t165).sub_product(m.factors[4], t166)
        .sub_product(R::literal(-2_777.777_777_777_778), t164).add_product(t17, t163);
    let cylinder_v_y_dot_by_plate_phi = (t15 * t163)
        .sub_product(R::literal(3.333_333_333_333_333_5), t165);
    let cylinder_v_x_dot_by_plate_phi = (-(m.factors[14] * t163))
        .add_product(R::literal(-3.333_333_333_333_333_5), t166);
    let plate_omega_dot_by_plate_phi = (t47 * R::literal(400.0)).sub_product(m.factors[0], t168)
        .add_product(t13, t167).sub_product(m.factors[0], t166).add_product(t13, t165)
        .add_product(t14, t160).sub_product(m.factors[38], t159);
    let plate_v_y_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t165)
        .add_product(R::literal(-0.833_333_333_333_333_4), t167)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t159);
    let plate_v_x_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t166)
        .add_product(R::literal(-0.833_333_333_333_333_4), t168)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t160);
    let post_omega_dot_by_plate_phi = (-(t12 * t169).add_product(m.factors[69], t170)
        .add_product(m.factors[69], t168)).add_product(t12, t167);
    let post_v_y_dot_by_plate_phi = (R::literal(1.25) * t167).add_product(R::literal(1.25), t169);
    let post_v_x_dot_by_plate_phi = (R::literal(1.25) * t168).add_product(R::literal(-1.25), t170);
    let t171 = R::literal(3.333_333_333_333_333_5) * t51;
    let t172 = t171.add_product(m.factors[4], t61);
    let t173 = R::literal(3.333_333_333_333_333_5) * t52;
    let t174 = (-t173).add_product(t16, t61).sub_product(t24, t172);
    let t175 = (R::literal(2_777.777_777_777_778) * t61).add_product(m.factors[12], t172)
        .sub_product(m.factors[13], t174);
    let t176 = (t36 - t62).sub_product(m.factors[14], t51).add_product(t15, t52).add_product(t17,
        t61).add_product(t18, t58).sub_product(m.factors[18], t59).sub_product(m.t97, t172)
        .sub_product(m.factors[20], t174).add_product(t26, t175);
    let t177 = R::literal(5.0) * t58;
    let t178 = t177.add_product(m.factors[23], t175).add_product(m.factors[24], t176);
    let t179 = R::literal(5.0) * t59;
    let t180 = (-t179).add_product(t27, t175).add_product(m.t135, t176).sub_product(m.t146, t178);
    let t181 = (-(t25 * t172).add_product(m.factors[33], t174)).add_product(t28, t175)
        .sub_product(m.factors[35], t176).sub_product(t30, t178).sub_product(m.factors[37], t180);
    let t182 = (-(m.t103 * t172).add_product(m.factors[42], t174)).add_product(t29, t175)
        .sub_product(m.factors[44], t176).sub_product(t31, t178).sub_product(m.factors[46], t180)
        .sub_product(m.factors[47], t181) * m.factors[48];
    let t183 = (t181 * m.factors[49]).sub_product(m.factors[47], t182);
    let t184 = (t180 * m.factors[50]).sub_product(m.factors[37], t183).sub_product(m.factors[46],
        t182);
    let t185 = (t178 * m.t143).add_product(m.t146, t184).add_product(t30, t183).add_product(t31,
        t182);
    let t186 = (t176 * m.factors[52]).sub_product(m.factors[24], t185).add_product(m.t135, t184)
        .sub_product(m.factors[35], t183).sub_product(m.factors[44], t182);
    let t187 = (t175 * m.factors[53]).add_product(t26, t186).sub_product(m.factors[23], t185)
        .add_product(t27, t184).add_product(t28, t183).add_product(t29, t182);
    let t188 = (t174 * m.factors[54]).sub_product(m.factors[13], t187).sub_product(m.factors[20],
        t186).sub_product(m.factors[33], t183).sub_product(m.factors[42], t182);
    let t189 = (t172 * m.t89).add_product(t24, t188).sub_product(m.factors[12], t187)
        .add_product(m.t97, t186).add_product(t25, t183).add_product(m.t103, t182);
    let t190 = (-(m.factors[9] * t188).add_product(m.factors[6], t189)).add_product(t23, t183)
        .sub_product(m.factors[40], t182);
    let t191 = (-(m.factors[5] * t189).add_product(m.factors[2], t190).add_product(m.factors[8],
        t188).add_product(m.factors[30], t183)).add_product(t22, t182);
    let t192 = (m.factors[59] * t190).add_product(m.factors[58], t191);
    let t193 = (t21 * t191).sub_product(t20, t192).add_product(t20, t190);
    let bobbin_v_y_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t182;
    let bobbin_v_x_dot_by_cylinder_x = R::literal(-1.428_571_428_571_428_6) * t183;
    let rod_omega_dot_by_cylinder_x = (t19 * t185).sub_product(R::literal(4_166.666_666_666_667),
        t187).sub_product(m.factors[64], t184);
    let rod_v_y_dot_by_cylinder_x = t179.sub_product(m.factors[18], t186)
        .sub_product(R::literal(5.0), t184);
    let rod_v_x_dot_by_cylinder_x = t177.add_product(t18, t186).sub_product(R::literal(5.0), t185);
    let cylinder_omega_dot_by_cylinder_x = (t61 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[4], t189).add_product(t16, t188)
        .sub_product(R::literal(-2_777.777_777_777_778), t187).add_product(t17, t186);
    let cylinder_v_y_dot_by_cylinder_x = t173.sub_product(R::literal(3.333_333_333_333_333_5), t188)
        .add_product(t15, t186);
    let cylinder_v_x_dot_by_cylinder_x = t171.sub_product(R::literal(3.333_333_333_333_333_5), t189)
        .sub_product(m.factors[14], t186);
    let plate_omega_dot_by_cylinder_x = (t13 * t190).sub_product(m.factors[0], t191)
        .sub_product(m.factors[0], t189).add_product(t13, t188).add_product(t14, t183)
        .sub_product(m.factors[38], t182);
    let plate_v_y_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t188)
        .add_product(R::literal(-0.833_333_333_333_333_4), t190)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t182);
    let plate_v_x_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t189)
        .add_product(R::literal(-0.833_333_333_333_333_4), t191)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t183);
    let post_omega_dot_by_cylinder_x = (-(t12 * t192).add_product(m.factors[69], t193)
        .add_product(m.factors[69], t191)).add_product(t12, t190);
    let post_v_y_dot_by_cylinder_x = (R::literal(1.25) * t190).add_product(R::literal(1.25), t192);
    let post_v_x_dot_by_cylinder_x = (R::literal(1.25) * t191).add_product(R::literal(-1.25), t193);
    let t194 = R::literal(3.333_333_333_333_333_5) * t64;
    let t195 = t194.sub_product(m.factors[4], t69);
    let t196 = R::literal(3.333_333_333_333_333_5) * t65;
    let t197 = t196.add_product(t16, t69).add_product(t24, t195);
    let t198 = (R::literal(-2_777.777_777_777_778) * t69).add_product(m.factors[12], t195)
        .add_product(m.factors[13], t197);
    let t199 = m.factors[14] * t64;
    let t200 = t15 * t65;
    let t201 = t18 * t64;
    let t202 = m.factors[18] * t65;
    let t203 = ((t199 - t70 - t200).add_product(t17, t69) + t201 - t202).add_product(m.t97, t195)
        .sub_product(m.factors[20], t197).sub_product(t26, t198);
    let t204 = R::literal(5.0) * t64;
    let t205 = (-t204).add_product(m.factors[23], t198).sub_product(m.factors[24], t203);
    let t206 = R::literal(5.0) * t65;
    let t207 = (-t206.add_product(t27, t198)).add_product(m.t135, t203).add_product(m.t146, t205);
    let t208 = (t25 * t195).sub_product(m.factors[33], t197).sub_product(t28, t198)
        .sub_product(m.factors[35], t203).add_product(t30, t205).sub_product(m.factors[37], t207);
    let t209 = (m.t103 * t195).sub_product(m.factors[42], t197).sub_product(t29, t198)
        .sub_product(m.factors[44], t203).add_product(t31, t205).sub_product(m.factors[46], t207)
        .sub_product(m.factors[47], t208) * m.factors[48];
    let t210 = (t208 * m.factors[49]).sub_product(m.factors[47], t209);
    let t211 = (t207 * m.factors[50]).sub_product(m.factors[37], t210).sub_product(m.factors[46],
        t209);
    let t212 = (-(t205 * m.t143)).add_product(m.t146, t211).add_product(t30, t210).add_product(t31,
        t209);
    let t213 = (t203 * m.factors[52]).sub_product(m.factors[24], t212).add_product(m.t135, t211)
        .sub_product(m.factors[35], t210).sub_product(m.factors[44], t209);
    let t214 = (-(t198 * m.factors[53])).add_product(t26, t213).sub_product(m.factors[23], t212)
        .add_product(t27, t211).add_product(t28, t210).add_product(t29, t209);
    let t215 = (t197 * m.factors[54]).sub_product(m.factors[13], t214).sub_product(m.factors[20],
        t213).sub_product(m.factors[33], t210).sub_product(m.factors[42], t209);
    let t216 = (-(t195 * m.t89)).add_product(t24, t215).sub_product(m.factors[12], t214)
        .add_product(m.t97, t213).add_product(t25, t210).add_product(m.t103, t209);
    let t217 = (-(m.factors[9] * t215).add_product(m.factors[6], t216)).add_product(t23, t210)
        .sub_product(m.factors[40], t209);
    let t218 = (-(m.factors[5] * t216).add_product(m.factors[2], t217).add_product(m.factors[8],
        t215).add_product(m.factors[30], t210)).add_product(t22, t209);
    let t219 = (m.factors[59] * t217).add_product(m.factors[58], t218);
    let t220 = (t21 * t218).sub_product(t20, t219).add_product(t20, t217);
    let bobbin_v_y_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t209;
    let bobbin_v_x_dot_by_cylinder_y = R::literal(-1.428_571_428_571_428_6) * t210;
    let rod_omega_dot_by_cylinder_y = (t19 * t212).sub_product(R::literal(4_166.666_666_666_667),
        t214).sub_product(m.factors[64], t211);
    let rod_v_y_dot_by_cylinder_y = t206.sub_product(m.factors[18], t213)
        .sub_product(R::literal(5.0), t211);
    let rod_v_x_dot_by_cylinder_y = t204.add_product(t18, t213).sub_product(R::literal(5.0), t212);
    let cylinder_omega_dot_by_cylinder_y = (t69 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[4], t216).add_product(t16, t215)
        .sub_product(R::literal(-2_777.777_777_777_778), t214).add_product(t17, t213);
    let cylinder_v_y_dot_by_cylinder_y = (-t196.add_product(R::literal(3.333_333_333_333_333_5),
        t215)).add_product(t15, t213);
    let cylinder_v_x_dot_by_cylinder_y = (-t194).add_product(R::literal(-3.333_333_333_333_333_5),
        t216).sub_product(m.factors[14], t213);
    let plate_omega_dot_by_cylinder_y = (t13 * t217).sub_product(m.factors[0], t218)
        .sub_product(m.factors[0], t216).add_product(t13, t215).add_product(t14, t210)
        .sub_product(m.factors[38], t209);
    let plate_v_y_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t215)
        .add_product(R::literal(-0.833_333_333_333_333_4), t217)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t209);
    let plate_v_x_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t216)
        .add_product(R::literal(-0.833_333_333_333_333_4), t218)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t210);
    let post_omega_dot_by_cylinder_y = (-(t12 * t219).add_product(m.factors[69], t220)
        .add_product(m.factors[69], t218)).add_product(t12, t217);
    let post_v_y_dot_by_cylinder_y = (R::literal(1.25) * t217).add_product(R::literal(1.25), t219);
    let post_v_x_dot_by_cylinder_y = (R::literal(1.25) * t218).add_product(R::literal(-1.25), t220);
    let t221 = R::literal(3.333_333_333_333_333_5) * t76;
    let t222 = ((-(t4 * m.cylinder_omega_dot)).add_product(t75, m.sin_cylinder_phi) - t221)
        .sub_product(m.factors[4], t79);
    let t223 = R::literal(3.333_333_333_333_333_5) * t77;
    let t224 = (-((t5 * m.cylinder_omega_dot).add_product(t75, m.cos_cylinder_phi) + t223))
        .add_product(t16, t79).add_product(t24, t222);
    let t225 = (R::literal(-2_777.777_777_777_778) * t79).add_product(m.factors[12], t222)
        .add_product(m.factors[13], t224);
    let t226 = (-(m.cos_cylinder_phi * m.cylinder_v_x_dot)).add_product(cylinder_omega,
        (t37 * m.sin_cylinder_phi).add_product(t40, m.cos_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, m.cos_cylinder_phi).add_product(cylinder_y * cylinder_omega,
        m.sin_cylinder_phi).sub_product(t38, m.cos_cylinder_phi).sub_product(t39,
        m.sin_cylinder_phi).sub_product(rod_x * cylinder_omega, m.cos_cylinder_phi)
        .sub_product(rod_y * cylinder_omega, m.sin_cylinder_phi)).sub_product(m.sin_cylinder_phi,
        m.cylinder_v_y_dot).sub_product(t78, m.cylinder_omega_dot).add_product(m.cos_cylinder_phi,
        m.rod_v_x_dot).sub_product(m.sin_cylinder_phi, m.t243).sub_product(m.factors[14], t76)
        .add_product(t15, t77).add_product(t17, t79).add_product(t18, t80)
        .sub_product(m.factors[18], t81).add_product(m.t97, t222);
    let t227 = t226.sub_product(m.factors[20], t224).sub_product(t26, t225);
    let t228 = R::literal(5.0) * t80;
    let t229 = (-t228).add_product(m.factors[23], t225).sub_product(m.factors[24], t227);
    let t230 = R::literal(5.0) * t81;
    let t231 = (-t230.add_product(t27, t225)).add_product(m.t135, t227).add_product(m.t146, t229);
    let t232 = (t25 * t222).sub_product(m.factors[33], t224).sub_product(t28, t225)
        .sub_product(m.factors[35], t227).add_product(t30, t229).sub_product(m.factors[37], t231);
    let t233 = (m.t103 * t222).sub_product(m.factors[42], t224).sub_product(t29, t225)
        .sub_product(m.factors[44], t227).add_product(t31, t229).sub_product(m.factors[46], t231)
        .sub_product(m.factors[47], t232) * m.factors[48];
    let t234 = (t232 * m.factors[49]).sub_product(m.factors[47], t233);
    let t235 = (t231 * m.factors[50]).sub_product(m.factors[37], t234).sub_product(m.factors[46],
        t233);
    let t236 = (-(t229 * m.t143)).add_product(m.t146, t235).add_product(t30, t234).add_product(t31,
        t233);
    let t237 = (t227 * m.factors[52]).sub_product(m.factors[24], t236).add_product(m.t135, t235)
        .sub_product(m.factors[35], t234).sub_product(m.factors[44], t233);
    let t238 = (-(t225 * m.factors[53])).add_product(t26, t237).sub_product(m.factors[23], t236)
        .add_product(t27, t235).add_product(t28, t234).add_product(t29, t233);
    let t239 = (t224 * m.factors[54]).sub_product(m.factors[13], t238).sub_product(m.factors[20],
        t237).sub_product(m.factors[33], t234).sub_product(m.factors[42], t233);
    let t240 = (-(t222 * m.t89)).add_product(t24, t239).sub_product(m.factors[12], t238)
        .add_product(m.t97, t237).add_product(t25, t234).add_product(m.t103, t233);
    let t241 = (-(m.factors[9] * t239).add_product(m.factors[6], t240)).add_product(t23, t234)
        .sub_product(m.factors[40], t233);
    let t242 = (-(m.factors[5] * t240).add_product(m.factors[2], t241).add_product(m.factors[8],
        t239).add_product(m.factors[30], t234)).add_product(t22, t233);
    let t243 = (m.factors[59] * t241).add_product(m.factors[58], t242);
    let t244 = (t21 * t242).sub_product(t20, t243).add_product(t20, t241);
    let bobbin_v_y_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t233;
    let bobbin_v_x_dot_by_cylinder_phi = R::literal(-1.428_571_428_571_428_6) * t234;
    let rod_omega_dot_by_cylinder_phi = (t19 * t236).sub_product(R::literal(4_166.666_666_666_667),
        t238).sub_product(m.factors[64], t235);
    let rod_v_y_dot_by_cylinder_phi = t230.sub_product(m.factors[18], t237)
        .sub_product(R::literal(5.0), t235);
    let rod_v_x_dot_by_cylinder_phi = t228.add_product(t18, t237).sub_product(R::literal(5.0),
        t236);
    let cylinder_omega_dot_by_cylinder_phi = (t79 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[4], t240).add_product(t16, t239)
        .sub_product(R::literal(-2_777.777_777_777_778), t238).add_product(t17, t237);
    let cylinder_v_y_dot_by_cylinder_phi = t223.sub_product(R::literal(3.333_333_333_333_333_5),
        t239).add_product(t15, t237);
    let cylinder_v_x_dot_by_cylinder_phi = t221.sub_product(R::literal(3.333_333_333_333_333_5),
        t240).sub_product(m.factors[14], t237);
    let plate_omega_dot_by_cylinder_phi = (t13 * t241).sub_product(m.factors[0], t242)
        .sub_product(m.factors[0], t240).add_product(t13, t239).add_product(t14, t234)
        .sub_product(m.factors[38], t233);
    let plate_v_y_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t239)
        .add_product(R::literal(-0.833_333_333_333_333_4), t241)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t233);
    let plate_v_x_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t240)
        .add_product(R::literal(-0.833_333_333_333_333_4), t242)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t234);
    let post_omega_dot_by_cylinder_phi = (-(t12 * t243).add_product(m.factors[69], t244)
        .add_product(m.factors[69], t242)).add_product(t12, t241);
    let post_v_y_dot_by_cylinder_phi = (R::literal(1.25) * t241).add_product(R::literal(1.25),
        t243);
    let post_v_x_dot_by_cylinder_phi = (R::literal(1.25) * t242).add_product(R::literal(-1.25),
        t244);
    let t245 = R::literal(3.333_333_333_333_333_5) * t58;
    let t246 = t245.add_product(m.factors[4], t82);
    let t247 = R::literal(3.333_333_333_333_333_5) * t59;
    let t248 = (-t247).add_product(t16, t82).sub_product(t24, t246);
    let t249 = (R::literal(2_777.777_777_777_778) * t82).add_product(m.factors[12], t246)
        .sub_product(m.factors[13], t248);
    let t250 = (t62 - t36).sub_product(m.factors[14], t58).add_product(t15, t59).add_product(t17,
        t82).add_product(t18, t51).sub_product(m.factors[18], t52).sub_product(m.t97, t246)
        .sub_product(m.factors[20], t248).add_product(t26, t249);
    let t251 = R::literal(5.0) * t51;
    let t252 = t251.add_product(m.factors[23], t249).add_product(m.factors[24], t250);
    let t253 = R::literal(5.0) * t52;
    let t254 = (-t253).add_product(t27, t249).add_product(m.t135, t250).sub_product(m.t146, t252);
    let t255 = (-(t25 * t246).add_product(m.factors[33], t248)).add_product(t28, t249)
        .sub_product(m.factors[35], t250).sub_product(t30, t252).sub_product(m.factors[37], t254);
    let t256 = (-(m.t103 * t246).add_product(m.factors[42], t248)).add_product(t29, t249)
        .sub_product(m.factors[44], t250).sub_product(t31, t252).sub_product(m.factors[46], t254)
        .sub_product(m.factors[47], t255) * m.factors[48];
    let t257 = (t255 * m.factors[49]).sub_product(m.factors[47], t256);
    let t258 = (t254 * m.factors[50]).sub_product(m.factors[37], t257).sub_product(m.factors[46],
        t256);
    let t259 = (t252 * m.t143).add_product(m.t146, t258).add_product(t30, t257).add_product(t31,
        t256);
    let t260 = (t250 * m.factors[52]).sub_product(m.factors[24], t259).add_product(m.t135, t258)
        .sub_product(m.factors[35], t257).sub_product(m.factors[44], t256);
    let t261 = (t249 * m.factors[53]).add_product(t26, t260).sub_product(m.factors[23], t259)
        .add_product(t27, t258).add_product(t28, t257).add_product(t29, t256);
    let t262 = (t248 * m.factors[54]).sub_product(m.factors[13], t261).sub_product(m.factors[20],
        t260).sub_product(m.factors[33], t257).sub_product(m.factors[42], t256);
    let t263 = (t246 * m.t89).add_product(t24, t262).sub_product(m.factors[12], t261)
        .add_product(m.t97, t260).add_product(t25, t257).add_product(m.t103, t256);
    let t264 = (-(m.factors[9] * t262).add_product(m.factors[6], t263)).add_product(t23, t257)
        .sub_product(m.factors[40], t256);
    let t265 = (-(m.factors[5] * t263).add_product(m.factors[2], t264).add_product(m.factors[8],
        t262).add_product(m.factors[30], t257)).add_product(t22, t256);
    let t266 = (m.factors[59] * t264).add_product(m.factors[58], t265);
    let t267 = (t21 * t265).sub_product(t20, t266).add_product(t20, t264);
    let bobbin_v_y_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t256;
    let bobbin_v_x_dot_by_rod_x = R::literal(-1.428_571_428_571_428_6) * t257;
    let rod_omega_dot_by_rod_x = (t19 * t259).sub_product(R::literal(4_166.666_666_666_667), t261)
        .sub_product(m.factors[64], t258);
    let rod_v_y_dot_by_rod_x = t253.sub_product(m.factors[18], t260).sub_product(R::literal(5.0),
        t258);
    let rod_v_x_dot_by_rod_x = t251.add_product(t18, t260).sub_product(R::literal(5.0), t259);
    let cylinder_omega_dot_by_rod_x = (t82 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[4], t263).add_product(t16, t262)
        .sub_product(R::literal(-2_777.777_777_777_778), t261).add_product(t17, t260);
    let cylinder_v_y_dot_by_rod_x = t247.sub_product(R::literal(3.333_333_333_333_333_5), t262)
        .add_product(t15, t260);
    let cylinder_v_x_dot_by_rod_x = t245.sub_product(R::literal(3.333_333_333_333_333_5), t263)
        .sub_product(m.factors[14], t260);
    let plate_omega_dot_by_rod_x = (t13 * t264).sub_product(m.factors[0], t265)
        .sub_product(m.factors[0], t263).add_product(t13, t262).add_product(t14, t257)
        .sub_product(m.factors[38], t256);
    let plate_v_y_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t262)
        .add_product(R::literal(-0.833_333_333_333_333_4), t264)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t256);
    let plate_v_x_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t263)
        .add_product(R::literal(-0.833_333_333_333_333_4), t265)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t257);
    let post_omega_dot_by_rod_x = (-(t12 * t266).add_product(m.factors[69], t267)
        .add_product(m.factors[69], t265)).add_product(t12, t264);
    let post_v_y_dot_by_rod_x = (R::literal(1.25) * t264).add_product(R::literal(1.25), t266);
    let post_v_x_dot_by_rod_x = (R::literal(1.25) * t265).add_product(R::literal(-1.25), t267);
    let t268 = t194.add_product(m.factors[4], t83);
    let t269 = (-t196).add_product(t16, t83).sub_product(t24, t268);
    let t270 = (R::literal(2_777.777_777_777_778) * t83).add_product(m.factors[12], t268)
        .sub_product(m.factors[13], t269);
    let t271 = ((t70 - t199 + t200).add_product(t17, t83) - t201 + t202).sub_product(m.t97, t268)
        .sub_product(m.factors[20], t269).add_product(t26, t270);
    let t272 = t204.sub_product(m.factors[23], t270).sub_product(m.factors[24], t271);
    let t273 = t206.add_product(t27, t270).add_product(m.t135, t271).add_product(m.t146, t272);
    let t274 = (-(t25 * t268).add_product(m.factors[33], t269)).add_product(t28, t270)
        .sub_product(m.factors[35], t271).add_product(t30, t272).sub_product(m.factors[37], t273);
    let t275 = (-(m.t103 * t268).add_product(m.factors[42], t269)).add_product(t29, t270)
        .sub_product(m.factors[44], t271).add_product(t31, t272).sub_product(m.factors[46], t273)
        .sub_product(m.factors[47], t274) * m.factors[48];
    let t276 = (t274 * m.factors[49]).sub_product(m.factors[47], t275);
    let t277 = (t273 * m.factors[50]).sub_product(m.factors[37], t276).sub_product(m.factors[46],
        t275);
    let t278 = (-(t272 * m.t143)).add_product(m.t146, t277).add_product(t30, t276).add_product(t31,
        t275);
    let t279 = (t271 * m.factors[52]).sub_product(m.factors[24], t278).add_product(m.t135, t277)
        .sub_product(m.factors[35], t276).sub_product(m.factors[44], t275);
    let t280 = (t270 * m.factors[53]).add_product(t26, t279).sub_product(m.factors[23], t278)
        .add_product(t27, t277).add_product(t28, t276).add_product(t29, t275);
    let t281 = (t269 * m.factors[54]).sub_product(m.factors[13], t280).sub_product(m.factors[20],
        t279).sub_product(m.factors[33], t276).sub_product(m.factors[42], t275);
    let t282 = (t268 * m.t89).add_product(t24, t281).sub_product(m.factors[12], t280)
        .add_product(m.t97, t279).add_product(t25, t276).add_product(m.t103, t275);
    let t283 = (-(m.factors[9] * t281).add_product(m.factors[6], t282)).add_product(t23, t276)
        .sub_product(m.factors[40], t275);
    let t284 = (-(m.factors[5] * t282).add_product(m.factors[2], t283).add_product(m.factors[8],
        t281).add_product(m.factors[30], t276)).add_product(t22, t275);
    let t285 = (m.factors[59] * t283).add_product(m.factors[58], t284);
    let t286 = (t21 * t284).sub_product(t20, t285).add_product(t20, t283);
    let bobbin_v_y_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t275;
    let bobbin_v_x_dot_by_rod_y = R::literal(-1.428_571_428_571_428_6) * t276;
    let rod_omega_dot_by_rod_y = (t19 * t278).sub_product(R::literal(4_166.666_666_666_667), t280)
        .sub_product(m.factors[64], t277);
    let rod_v_y_dot_by_rod_y = (-t206.add_product(m.factors[18], t279))
        .add_product(R::literal(-5.0), t277);
    let rod_v_x_dot_by_rod_y = (-t204).add_product(t18, t279).sub_product(R::literal(5.0), t278);
    let cylinder_omega_dot_by_rod_y = (t83 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[4], t282).add_product(t16, t281)
        .sub_product(R::literal(-2_777.777_777_777_778), t280).add_product(t17, t279);
    let cylinder_v_y_dot_by_rod_y = t196.sub_product(R::literal(3.333_333_333_333_333_5), t281)
        .add_product(t15, t279);
    let cylinder_v_x_dot_by_rod_y = t194.sub_product(R::literal(3.333_333_333_333_333_5), t282)
        .sub_product(m.factors[14], t279);
    let plate_omega_dot_by_rod_y = (t13 * t283).sub_product(m.factors[0], t284)
        .sub_product(m.factors[0], t282).add_product(t13, t281).add_product(t14, t276)
        .sub_product(m.factors[38], t275);
    let plate_v_y_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t281)
        .add_product(R::literal(-0.833_333_333_333_333_4), t283)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t275);
    let plate_v_x_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t282)
        .add_product(R::literal(-0.833_333_333_333_333_4), t284)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t276);
    let post_omega_dot_by_rod_y = (-(t12 * t285).add_product(m.factors[69], t286)
        .add_product(m.factors[69], t284)).add_product(t12, t283);
    let post_v_y_dot_by_rod_y = (R::literal(1.25) * t283).add_product(R::literal(1.25), t285);
    let post_v_x_dot_by_rod_y = (R::literal(1.25) * t284).add_product(R::literal(-1.25), t286);
    let t287 = R::literal(4_166.666_666_666_667) * t84;
    let t288 = t26 * t287;
    let t289 = (-m.t194).add_product(t6, m.rod_omega_dot).add_product(t19, t84)
        .add_product(m.factors[23], t287).add_product(m.factors[24], t288);
    let t290 = m.t193.add_product(t7, m.rod_omega_dot).sub_product(m.factors[64], t84)
        .sub_product(t27, t287).sub_product(m.t135, t288).add_product(m.t146, t289);
    let t291 = (-(t28 * t287)).add_product(m.factors[35], t288).add_product(t30, t289)
        .sub_product(m.factors[37], t290);
    let t292 = (-(t29 * t287)).add_product(m.factors[44], t288).add_product(t31, t289)
        .sub_product(m.factors[46], t290).sub_product(m.factors[47], t291) * m.factors[48];
    let t293 = (t291 * m.factors[49]).sub_product(m.factors[47], t292);
    let t294 = (t290 * m.factors[50]).sub_product(m.factors[37], t293).sub_product(m.factors[46],
        t292);
    let t295 = (-(t289 * m.t143)).add_product(m.t146, t294).add_product(t30, t293).add_product(t31,
        t292);
    let t296 = (-(t288 * m.factors[52]).add_product(m.factors[24], t295)).add_product(m.t135, t294)
        .sub_product(m.factors[35], t293).sub_product(m.factors[44], t292);
    let t297 = (-(t287 * m.factors[53])).add_product(t26, t296).sub_product(m.factors[23], t295)
        .add_product(t27, t294).add_product(t28, t293).add_product(t29, t292);
    let t298 = (m.factors[20] * t296).add_product(m.factors[13], t297).add_product(m.factors[33],
        t293).add_product(m.factors[42], t292);
    let t299 = (-(m.factors[12] * t297).add_product(t24, t298)).add_product(m.t97, t296)
        .add_product(t25, t293).add_product(m.t103, t292);
    let t300 = (m.factors[9] * t298).sub_product(m.factors[6], t299).add_product(t23, t293)
        .sub_product(m.factors[40], t292);
    let t301 = (-(m.factors[5] * t299).add_product(m.factors[2], t300)).add_product(m.factors[8],
        t298).sub_product(m.factors[30], t293).add_product(t22, t292);
    let t302 = (m.factors[59] * t300).add_product(m.factors[58], t301);
    let t303 = (t21 * t301).sub_product(t20, t302).add_product(t20, t300);
    let bobbin_v_y_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t292;
    let bobbin_v_x_dot_by_rod_phi = R::literal(-1.428_571_428_571_428_6) * t293;
    let rod_omega_dot_by_rod_phi = t287.sub_product(R::literal(4_166.666_666_666_667), t297)
        .add_product(t19, t295).sub_product(m.factors[64], t294);
    let rod_v_y_dot_by_rod_phi = (R::literal(-5.0) * t294).sub_product(m.factors[18], t296);
    let rod_v_x_dot_by_rod_phi = (R::literal(-5.0) * t295).add_product(t18, t296);
    let cylinder_omega_dot_by_rod_phi = (-(t16 * t298).add_product(m.factors[4], t299)
        .add_product(R::literal(-2_777.777_777_777_778), t297)).add_product(t17, t296);
    let cylinder_v_y_dot_by_rod_phi = (t15 * t296).add_product(R::literal(3.333_333_333_333_333_5),
        t298);
    let cylinder_v_x_dot_by_rod_phi = (-(m.factors[14] * t296))
        .add_product(R::literal(-3.333_333_333_333_333_5), t299);
    let plate_omega_dot_by_rod_phi = (t13 * t300).sub_product(m.factors[0], t301)
        .sub_product(m.factors[0], t299).sub_product(t13, t298).add_product(t14, t293)
        .sub_product(m.factors[38], t292);
    let plate_v_y_dot_by_rod_phi = (R::literal(-0.833_333_333_333_333_4) * t298)
        .sub_product(R::literal(0.833_333_333_333_333_4), t300)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t292);
    let plate_v_x_dot_by_rod_phi = (R::literal(0.833_333_333_333_333_4) * t299)
        .add_product(R::literal(-0.833_333_333_333_333_4), t301)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t293);
    let post_omega_dot_by_rod_phi = (-(t12 * t302).add_product(m.factors[69], t303)
        .add_product(m.factors[69], t301)).add_product(t12, t300);
    let post_v_y_dot_by_rod_phi = (R::literal(1.25) * t300).add_product(R::literal(1.25), t302);
    let post_v_x_dot_by_rod_phi = (R::literal(1.25) * t301).add_product(R::literal(-1.25), t303);
    let t304 = m.factors[0] * t89;
    let t305 = t13 * t89;
    let t306 = t305.add_product(m.factors[2], t304);
    let t307 = (-t304).add_product(m.factors[5], t304).sub_product(m.factors[6], t306);
    let t308 = t305.add_product(m.factors[8], t304).sub_product(m.factors[9], t306)
        .add_product(t24, t307);
    let t309 = (m.factors[12] * t307).add_product(m.factors[13], t308);
    let t310 = (m.t97 * t307).sub_product(m.factors[20], t308).sub_product(t26, t309);
    let t311 = (m.factors[23] * t309).sub_product(m.factors[24], t310);
    let t312 = (-(t27 * t309)).add_product(m.t135, t310).add_product(m.t146, t311);
    let t313 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t94 * m.t9 / t93 - t95
        + contact_stiffness_times_contact_gap * m.t9 / t93 - contact_damping_times_bobbin_v_x * t8
        / t86 - t90 * t87 / m.between - t91 - p.contact_stiffness * m.t9 / t86 - t92);
    let t314 = (-t313).add_product(t14, t89).add_product(m.factors[30], t304).add_product(t23, t306)
        .add_product(t25, t307).sub_product(m.factors[33], t308).sub_product(t28, t309)
        .sub_product(m.factors[35], t310).add_product(t30, t311).sub_product(m.factors[37], t312);
    let t315 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t96 - t97 + t98 * t87 / m.between
        - contact_damping_times_bobbin_v_x * t9 / t86 + t10 * m.t9 / t93 - (t100 - t99));
    let t316 = (-t315.add_product(m.factors[38], t89).add_product(t22, t304)
        .add_product(m.factors[40], t306)).add_product(m.t103, t307).sub_product(m.factors[42],
        t308).sub_product(t29, t309).sub_product(m.factors[44], t310).add_product(t31, t311)
        .sub_product(m.factors[46], t312).sub_product(m.factors[47], t314) * m.factors[48];
    let t317 = (t314 * m.factors[49]).sub_product(m.factors[47], t316);
    let t318 = (t312 * m.factors[50]).sub_product(m.factors[37], t317).sub_product(m.factors[46],
        t316);
    let t319 = (-(t311 * m.t143)).add_product(m.t146, t318).add_product(t30, t317).add_product(t31,
        t316);
    let t320 = (t310 * m.factors[52]).sub_product(m.factors[24], t319).add_product(m.t135, t318)
        .sub_product(m.factors[35], t317).sub_product(m.factors[44], t316);
    let t321 = (-(t309 * m.factors[53])).add_product(t26, t320).sub_product(m.factors[23], t319)
        .add_product(t27, t318).add_product(t28, t317).add_product(t29, t316);
    let t322 = (t308 * m.factors[54]).sub_product(m.factors[13], t321).sub_product(m.factors[20],
        t320).sub_product(m.factors[33], t317).sub_product(m.factors[42], t316);
    let t323 = (-(t307 * m.t89)).add_product(t24, t322).sub_product(m.factors[12], t321)
        .add_product(m.t97, t320).add_product(t25, t317).add_product(m.t103, t316);
    let t324 = (t306 * m.factors[56]).sub_product(m.factors[6], t323).sub_product(m.factors[9],
        t322).add_product(t23, t317).sub_product(m.factors[40], t316);
    let t325 = (-(t304 * m.factors[57]).add_product(m.factors[2], t324).add_product(m.factors[5],
        t323).add_product(m.factors[8], t322).add_product(m.factors[30], t317)).add_product(t22,
        t316);
    let t326 = (m.factors[59] * t324).add_product(m.factors[58], t325);
    let t327 = (t21 * t325).sub_product(t20, t326).add_product(t20, t324);
    let bobbin_v_y_dot_by_bobbin_x = t315.sub_product(R::literal(1.428_571_428_571_428_6), t316);
    let bobbin_v_x_dot_by_bobbin_x = t313.sub_product(R::literal(1.428_571_428_571_428_6), t317);
    let rod_omega_dot_by_bobbin_x = (t19 * t319).sub_product(R::literal(4_166.666_666_666_667),
        t321).sub_product(m.factors[64], t318);
    let rod_v_y_dot_by_bobbin_x = (R::literal(-5.0) * t318).sub_product(m.factors[18], t320);
    let rod_v_x_dot_by_bobbin_x = (R::literal(-5.0) * t319).add_product(t18, t320);
    let cylinder_omega_dot_by_bobbin_x = (t16 * t322).sub_product(m.factors[4], t323)
        .sub_product(R::literal(-2_777.777_777_777_778), t321).add_product(t17, t320);
    let cylinder_v_y_dot_by_bobbin_x = (t15 * t320)
        .sub_product(R::literal(3.333_333_333_333_333_5), t322);
    let cylinder_v_x_dot_by_bobbin_x = (-(m.factors[14] * t320))
        .add_product(R::literal(-3.333_333_333_333_333_5), t323);
    let plate_omega_dot_by_bobbin_x = (t89 * R::literal(400.0)).sub_product(m.factors[0], t325)
        .add_product(t13, t324).sub_product(m.factors[0], t323).add_product(t13, t322)
        .add_product(t14, t317).sub_product(m.factors[38], t316);
    let plate_v_y_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t322)
        .add_product(R::literal(-0.833_333_333_333_333_4), t324)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t316);
    let plate_v_x_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t323)
        .add_product(R::literal(-0.833_333_333_333_333_4), t325)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t317);
    let post_omega_dot_by_bobbin_x = (-(t12 * t326).add_product(m.factors[69], t327)
        .add_product(m.factors[69], t325)).add_product(t12, t324);
    let post_v_y_dot_by_bobbin_x = (R::literal(1.25) * t324).add_product(R::literal(1.25), t326);
    let post_v_x_dot_by_bobbin_x = (R::literal(1.25) * t325).add_product(R::literal(-1.25), t327);
    let t328 = m.factors[0] * t102;
    let t329 = t13 * t102;
    let t330 = t329.add_product(m.factors[2], t328);
    let t331 = (-t328).add_product(m.factors[5], t328).sub_product(m.factors[6], t330);
    let t332 = t329.add_product(m.factors[8], t328).sub_product(m.factors[9], t330)
        .add_product(t24, t331);
    let t333 = (m.factors[12] * t331).add_product(m.factors[13], t332);
    let t334 = (m.t97 * t331).sub_product(m.factors[20], t332).sub_product(t26, t333);
    let t335 = (m.factors[23] * t333).sub_product(m.factors[24], t334);
    let t336 = (-(t27 * t333)).add_product(m.t135, t334).add_product(m.t146, t335);
    let t337 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t96 - t10 * m.t11 / t93 + t99
        - contact_damping_times_bobbin_v_y * t8 / t86 + t97 - t90 * t101 / m.between - t100);
    let t338 = (-t337).add_product(t14, t102).add_product(m.factors[30], t328).add_product(t23,
        t330).add_product(t25, t331).sub_product(m.factors[33], t332).sub_product(t28, t333)
        .sub_product(m.factors[35], t334).add_product(t30, t335).sub_product(m.factors[37], t336);
    let t339 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t94 * m.t11 / t93 + t98 * t101 / m.between
        - contact_damping_times_bobbin_v_y * t9 / t86 + t95 - t92 - (t91 + p.contact_stiffness
        * m.t11 / t86 - contact_stiffness_times_contact_gap * m.t11 / t93));
    let t340 = (-t339.add_product(m.factors[38], t102).add_product(t22, t328)
        .add_product(m.factors[40], t330)).add_product(m.t103, t331).sub_product(m.factors[42],
        t332).sub_product(t29, t333).sub_product(m.factors[44], t334).add_product(t31, t335)
        .sub_product(m.factors[46], t336).sub_product(m.factors[47], t338) * m.factors[48];
    let t341 = (t338 * m.factors[49]).sub_product(m.factors[47], t340);
    let t342 = (t336 * m.factors[50]).sub_product(m.factors[37], t341).sub_product(m.factors[46],
        t340);
    let t343 = (-(t335 * m.t143)).add_product(m.t146, t342).add_product(t30, t341).add_product(t31,
        t340);
    let t344 = (t334 * m.factors[52]).sub_product(m.factors[24], t343).add_product(m.t135, t342)
        .sub_product(m.factors[35], t341).sub_product(m.factors[44], t340);
    let t345 = (-(t333 * m.factors[53])).add_product(t26, t344).sub_product(m.factors[23], t343)
        .add_product(t27, t342).add_product(t28, t341).add_product(t29, t340);
    let t346 = (t332 * m.factors[54]).sub_product(m.factors[13], t345).sub_product(m.factors[20],
        t344).sub_product(m.factors[33], t341).sub_product(m.factors[42], t340);
    let t347 = (-(t331 * m.t89)).add_product(t24, t346).sub_product(m.factors[12], t345)
        .add_product(m.t97, t344).add_product(t25, t341).add_product(m.t103, t340);
    let t348 = (t330 * m.factors[56]).sub_product(m.factors[6], t347).sub_product(m.factors[9],
        t346).add_product(t23, t341).sub_product(m.factors[40], t340);
    let t349 = (-(t328 * m.factors[57]).add_product(m.factors[2], t348).add_product(m.factors[5],
        t347).add_product(m.factors[8], t346).add_product(m.factors[30], t341)).add_product(t22,
        t340);
    let t350 = (m.factors[59] * t348).add_product(m.factors[58], t349);
    let t351 = (t21 * t349).sub_product(t20, t350).add_product(t20, t348);
    let bobbin_v_y_dot_by_bobbin_y = t339.sub_product(R::literal(1.428_571_428_571_428_6), t340);
    let bobbin_v_x_dot_by_bobbin_y = t337.sub_product(R::literal(1.428_571_428_571_428_6), t341);
    let rod_omega_dot_by_bobbin_y = (t19 * t343).sub_product(R::literal(4_166.666_666_666_667),
        t345).sub_product(m.factors[64], t342);
    let rod_v_y_dot_by_bobbin_y = (R::literal(-5.0) * t342).sub_product(m.factors[18], t344);
    let rod_v_x_dot_by_bobbin_y = (R::literal(-5.0) * t343).add_product(t18, t344);
    let cylinder_omega_dot_by_bobbin_y = (t16 * t346).sub_product(m.factors[4], t347)
        .sub_product(R::literal(-2_777.777_777_777_778), t345).add_product(t17, t344);
    let cylinder_v_y_dot_by_bobbin_y = (t15 * t344)
        .sub_product(R::literal(3.333_333_333_333_333_5), t346);
    let cylinder_v_x_dot_by_bobbin_y = (-(m.factors[14] * t344))
        .add_product(R::literal(-3.333_333_333_333_333_5), t347);
    let plate_omega_dot_by_bobbin_y = (t102 * R::literal(400.0)).sub_product(m.factors[0], t349)
        .add_product(t13, t348).sub_product(m.factors[0], t347).add_product(t13, t346)
        .add_product(t14, t341).sub_product(m.factors[38], t340);
    let plate_v_y_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t346)
        .add_product(R::literal(-0.833_333_333_333_333_4), t348)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t340);
    let plate_v_x_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t347)
        .add_product(R::literal(-0.833_333_333_333_333_4), t349)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t341);
    let post_omega_dot_by_bobbin_y = (-(t12 * t350).add_product(m.factors[69], t351)
        .add_product(m.factors[69], t349)).add_product(t12, t348);
    let post_v_y_dot_by_bobbin_y = (R::literal(1.25) * t348).add_product(R::literal(1.25), t350);
    let post_v_x_dot_by_bobbin_y = (R::literal(1.25) * t349).add_product(R::literal(-1.25), t351);
    let t352 = (t104 * m.cos_post_phi).add_product(m.factors[69], t103);
    let t353 = (-(t104 * m.sin_post_phi)).add_product(t12, t103).sub_product(t20, t352);
    let t354 = t352.add_product(t21, t352).add_product(m.factors[58], t353);
    let t355 = t353.sub_product(m.factors[59], t353).add_product(m.factors[2], t354);
    let t356 = (m.factors[5] * t354).sub_product(m.factors[6], t355);
    let t357 = (m.factors[8] * t354).sub_product(m.factors[9], t355).add_product(t24, t356);
    let t358 = (m.factors[12] * t356).add_product(m.factors[13], t357);
    let t359 = (m.t97 * t356).sub_product(m.factors[20], t357).sub_product(t26, t358);
    let t360 = (m.factors[23] * t358).sub_product(m.factors[24], t359);
    let t361 = (-(t27 * t358)).add_product(m.t135, t359).add_product(m.t146, t360);
    let t362 = (m.factors[30] * t354).add_product(t23, t355).add_product(t25, t356)
        .sub_product(m.factors[33], t357).sub_product(t28, t358).sub_product(m.factors[35], t359)
        .add_product(t30, t360).sub_product(m.factors[37], t361);
    let t363 = (-(t22 * t354).add_product(m.factors[40], t355)).add_product(m.t103, t356)
        .sub_product(m.factors[42], t357).sub_product(t29, t358).sub_product(m.factors[44], t359)
        .add_product(t31, t360).sub_product(m.factors[46], t361).sub_product(m.factors[47], t362)
        * m.factors[48];
    let t364 = (t362 * m.factors[49]).sub_product(m.factors[47], t363);
    let t365 = (t361 * m.factors[50]).sub_product(m.factors[37], t364).sub_product(m.factors[46],
        t363);
    let t366 = (-(t360 * m.t143)).add_product(m.t146, t365).add_product(t30, t364).add_product(t31,
        t363);
    let t367 = (t359 * m.factors[52]).sub_product(m.factors[24], t366).add_product(m.t135, t365)
        .sub_product(m.factors[35], t364).sub_product(m.factors[44], t363);
    let t368 = (-(t358 * m.factors[53])).add_product(t26, t367).sub_product(m.factors[23], t366)
        .add_product(t27, t365).add_product(t28, t364).add_product(t29, t363);
    let t369 = (t357 * m.factors[54]).sub_product(m.factors[13], t368).sub_product(m.factors[20],
        t367).sub_product(m.factors[33], t364).sub_product(m.factors[42], t363);
    let t370 = (-(t356 * m.t89)).add_product(t24, t369).sub_product(m.factors[12], t368)
        .add_product(m.t97, t367).add_product(t25, t364).add_product(m.t103, t363);
    let t371 = (t355 * m.factors[56]).sub_product(m.factors[6], t370).sub_product(m.factors[9],
        t369).add_product(t23, t364).sub_product(m.factors[40], t363);
    let t372 = (-(t354 * m.factors[57]).add_product(m.factors[2], t371).add_product(m.factors[5],
        t370).add_product(m.factors[8], t369).add_product(m.factors[30], t364)).add_product(t22,
        t363);
    let t373 = (t353 * m.t52).sub_product(m.factors[58], t372).sub_product(m.factors[59], t371);
    let t374 = (t352 * m.t42).add_product(t20, t373).add_product(t21, t372).add_product(t20, t371);
    let bobbin_v_y_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t363;
    let bobbin_v_x_dot_by_post_omega = R::literal(-1.428_571_428_571_428_6) * t364;
    let rod_omega_dot_by_post_omega = (t19 * t366).sub_product(R::literal(4_166.666_666_666_667),
        t368).sub_product(m.factors[64], t365);
    let rod_v_y_dot_by_post_omega = (R::literal(-5.0) * t365).sub_product(m.factors[18], t367);
    let rod_v_x_dot_by_post_omega = (R::literal(-5.0) * t366).add_product(t18, t367);
    let cylinder_omega_dot_by_post_omega = (t16 * t369).sub_product(m.factors[4], t370)
        .sub_product(R::literal(-2_777.777_777_777_778), t368).add_product(t17, t367);
    let cylinder_v_y_dot_by_post_omega = (t15 * t367)
        .sub_product(R::literal(3.333_333_333_333_333_5), t369);
    let cylinder_v_x_dot_by_post_omega = (-(m.factors[14] * t367))
        .add_product(R::literal(-3.333_333_333_333_333_5), t370);
    let plate_omega_dot_by_post_omega = (t13 * t371).sub_product(m.factors[0], t372)
        .sub_product(m.factors[0], t370).add_product(t13, t369).add_product(t14, t364)
        .sub_product(m.factors[38], t363);
    let plate_v_y_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t369)
        .add_product(R::literal(-0.833_333_333_333_333_4), t371)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t363);
    let plate_v_x_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t370)
        .add_product(R::literal(-0.833_333_333_333_333_4), t372)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t364);
    let post_omega_dot_by_post_omega = (t103 * R::literal(370.370_370_370_370_3))
        .sub_product(m.factors[69], t374).add_product(t12, t373).sub_product(m.factors[69], t372)
        .add_product(t12, t371);
    let post_v_y_dot_by_post_omega = (R::literal(1.25) * t371).add_product(R::literal(-1.25), t373);
    let post_v_x_dot_by_post_omega = (R::literal(1.25) * t372).add_product(R::literal(-1.25), t374);
    let t375 = (-t107).add_product(m.factors[2], t106);
    let t376 = (-t106).add_product(m.factors[5], t106).sub_product(m.factors[6], t375);
    let t377 = (-t107).add_product(m.factors[8], t106).sub_product(m.factors[9], t375)
        .add_product(t24, t376);
    let t378 = (m.factors[12] * t376).add_product(m.factors[13], t377);
    let t379 = (m.t97 * t376).sub_product(m.factors[20], t377).sub_product(t26, t378);
    let t380 = (m.factors[23] * t378).sub_product(m.factors[24], t379);
    let t381 = (-(t27 * t378)).add_product(m.t135, t379).add_product(m.t146, t380);
    let t382 = (plate_omega * (R::literal(0.02) * m.cos_plate_phi).sub_product(R::literal(0.2),
        m.sin_plate_phi)).add_product(m.factors[30], t106).add_product(t23, t375).add_product(t25,
        t376).sub_product(m.factors[33], t377).sub_product(t28, t378).sub_product(m.factors[35],
        t379).add_product(t30, t380).sub_product(m.factors[37], t381);
    let t383 = (plate_omega * (R::literal(0.02) * m.sin_plate_phi).add_product(R::literal(0.2),
        m.cos_plate_phi)).sub_product(t22, t106).sub_product(m.factors[40], t375)
        .add_product(m.t103, t376).sub_product(m.factors[42], t377).sub_product(t29, t378)
        .sub_product(m.factors[44], t379).add_product(t31, t380).sub_product(m.factors[46], t381)
        .sub_product(m.factors[47], t382) * m.factors[48];
    let t384 = (t382 * m.factors[49]).sub_product(m.factors[47], t383);
    let t385 = (t381 * m.factors[50]).sub_product(m.factors[37], t384).sub_product(m.factors[46],
        t383);
    let t386 = (-(t380 * m.t143)).add_product(m.t146, t385).add_product(t30, t384).add_product(t31,
        t383);
    let t387 = (t379 * m.factors[52]).sub_product(m.factors[24], t386).add_product(m.t135, t385)
        .sub_product(m.factors[35], t384).sub_product(m.factors[44], t383);
    let t388 = (-(t378 * m.factors[53])).add_product(t26, t387).sub_product(m.factors[23], t386)
        .add_product(t27, t385).add_product(t28, t384).add_product(t29, t383);
    let t389 = (t377 * m.factors[54]).sub_product(m.factors[13], t388).sub_product(m.factors[20],
        t387).sub_product(m.factors[33], t384).sub_product(m.factors[42], t383);
    let t390 = (-(t376 * m.t89)).add_product(t24, t389).sub_product(m.factors[12], t388)
        .add_product(m.t97, t387).add_product(t25, t384).add_product(m.t103, t383);
    let t391 = (t375 * m.factors[56]).sub_product(m.factors[6], t390).sub_product(m.factors[9],
        t389).add_product(t23, t384).sub_product(m.factors[40], t383);
    let t392 = (-(t106 * m.factors[57]).add_product(m.factors[2], t391).add_product(m.factors[5],
        t390).add_product(m.factors[8], t389).add_product(m.factors[30], t384)).add_product(t22,
        t383);
    let t393 = (m.factors[59] * t391).add_product(m.factors[58], t392);
    let t394 = (t21 * t392).sub_product(t20, t393).add_product(t20, t391);
    let bobbin_v_y_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t383;
    let bobbin_v_x_dot_by_plate_omega = R::literal(-1.428_571_428_571_428_6) * t384;
    let rod_omega_dot_by_plate_omega = (t19 * t386).sub_product(R::literal(4_166.666_666_666_667),
        t388).sub_product(m.factors[64], t385);
    let rod_v_y_dot_by_plate_omega = (R::literal(-5.0) * t385).sub_product(m.factors[18], t387);
    let rod_v_x_dot_by_plate_omega = (R::literal(-5.0) * t386).add_product(t18, t387);
    let cylinder_omega_dot_by_plate_omega = (t16 * t389).sub_product(m.factors[4], t390)
        .sub_product(R::literal(-2_777.777_777_777_778), t388).add_product(t17, t387);
    let cylinder_v_y_dot_by_plate_omega = (t15 * t387)
        .sub_product(R::literal(3.333_333_333_333_333_5), t389);
    let cylinder_v_x_dot_by_plate_omega = (-(m.factors[14] * t387))
        .add_product(R::literal(-3.333_333_333_333_333_5), t390);
    let plate_omega_dot_by_plate_omega = (t13 * t391).sub_product(m.factors[0], t392)
        .sub_product(m.factors[0], t390).add_product(t13, t389).add_product(t14, t384)
        .sub_product(m.factors[38], t383);
    let plate_v_y_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t389)
        .add_product(R::literal(-0.833_333_333_333_333_4), t391)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t383);
    let plate_v_x_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t390)
        .add_product(R::literal(-0.833_333_333_333_333_4), t392)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t384);
    let post_omega_dot_by_plate_omega = (-(t12 * t393).add_product(m.factors[69], t394)
        .add_product(m.factors[69], t392)).add_product(t12, t391);
    let post_v_y_dot_by_plate_omega = (R::literal(1.25) * t391).add_product(R::literal(1.25), t393);
    let post_v_x_dot_by_plate_omega = (R::literal(1.25) * t392).add_product(R::literal(-1.25),
        t394);
    let t395 = R::literal(3.333_333_333_333_333_5) * t108;
    let t396 = m.factors[4] * t111;
    let t397 = t395 - t396;
    let t398 = R::literal(3.333_333_333_333_333_5) * t109;
    let t399 = t398.add_product(t16, t111);
    let t400 = t399.add_product(t24, t397);
    let t401 = R::literal(-2_777.777_777_777_778) * t111;
    let t402 = t401.add_product(m.factors[12], t397).add_product(m.factors[13], t400);
    let t403 = m.factors[14] * t108;
    let t404 = t15 * t109;
    let t405 = t17 * t111;
    let t406 = t18 * t108;
    let t407 = m.factors[18] * t109;
    let t408 = (t403 - t113 - t404 + t405 + t406 - t407).add_product(m.t97, t397)
        .sub_product(m.factors[20], t400).sub_product(t26, t402);
    let t409 = R::literal(5.0) * t108;
    let t410 = (-t409).add_product(m.factors[23], t402).sub_product(m.factors[24], t408);
    let t411 = R::literal(5.0) * t109;
    let t412 = (-t411.add_product(t27, t402)).add_product(m.t135, t408).add_product(m.t146, t410);
    let t413 = (t25 * t397).sub_product(m.factors[33], t400).sub_product(t28, t402)
        .sub_product(m.factors[35], t408).add_product(t30, t410).sub_product(m.factors[37], t412);
    let t414 = (m.t103 * t397).sub_product(m.factors[42], t400).sub_product(t29, t402)
        .sub_product(m.factors[44], t408).add_product(t31, t410).sub_product(m.factors[46], t412)
        .sub_product(m.factors[47], t413) * m.factors[48];
    let t415 = (t413 * m.factors[49]).sub_product(m.factors[47], t414);
    let t416 = (t412 * m.factors[50]).sub_product(m.factors[37], t415).sub_product(m.factors[46],
        t414);
    let t417 = (-(t410 * m.t143)).add_product(m.t146, t416).add_product(t30, t415).add_product(t31,
        t414);
    let t418 = (t408 * m.factors[52]).sub_product(m.factors[24], t417).add_product(m.t135, t416)
        .sub_product(m.factors[35], t415).sub_product(m.factors[44], t414);
    let t419 = (-(t402 * m.factors[53])).add_product(t26, t418).sub_product(m.factors[23], t417)
        .add_product(t27, t416).add_product(t28, t415).add_product(t29, t414);
    let t420 = (t400 * m.factors[54]).sub_product(m.factors[13], t419).sub_product(m.factors[20],
        t418).sub_product(m.factors[33], t415).sub_product(m.factors[42], t414);
    let t421 = (-(t397 * m.t89)).add_product(t24, t420).sub_product(m.factors[12], t419)
        .add_product(m.t97, t418).add_product(t25, t415).add_product(m.t103, t414);
    let t422 = (-(m.factors[9] * t420).add_product(m.factors[6], t421)).add_product(t23, t415)
        .sub_product(m.factors[40], t414);
    let t423 = (-(m.factors[5] * t421).add_product(m.factors[2], t422).add_product(m.factors[8],
        t420).add_product(m.factors[30], t415)).add_product(t22, t414);
    let t424 = (m.factors[59] * t422).add_product(m.factors[58], t423);
    let t425 = (t21 * t423).sub_product(t20, t424).add_product(t20, t422);
    let bobbin_v_y_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t414;
    let bobbin_v_x_dot_by_cylinder_v_x = R::literal(-1.428_571_428_571_428_6) * t415;
    let rod_omega_dot_by_cylinder_v_x = (t19 * t417).sub_product(R::literal(4_166.666_666_666_667),
        t419).sub_product(m.factors[64], t416);
    let rod_v_y_dot_by_cylinder_v_x = t411.sub_product(m.factors[18], t418)
        .sub_product(R::literal(5.0), t416);
    let rod_v_x_dot_by_cylinder_v_x = t409.add_product(t18, t418).sub_product(R::literal(5.0),
        t417);
    let t426 = t111 * R::literal(2_777.777_777_777_778);
    let cylinder_omega_dot_by_cylinder_v_x = t426.sub_product(m.factors[4], t421).add_product(t16,
        t420).sub_product(R::literal(-2_777.777_777_777_778), t419).add_product(t17, t418);
    let cylinder_v_y_dot_by_cylinder_v_x = (-t398.add_product(R::literal(3.333_333_333_333_333_5),
        t420)).add_product(t15, t418);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t395)
        .add_product(R::literal(-3.333_333_333_333_333_5), t421).sub_product(m.factors[14], t418);
    let plate_omega_dot_by_cylinder_v_x = (t13 * t422).sub_product(m.factors[0], t423)
        .sub_product(m.factors[0], t421).add_product(t13, t420).add_product(t14, t415)
        .sub_product(m.factors[38], t414);
    let plate_v_y_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t420)
        .add_product(R::literal(-0.833_333_333_333_333_4), t422)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t414);
    let plate_v_x_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t421)
        .add_product(R::literal(-0.833_333_333_333_333_4), t423)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t415);
    let post_omega_dot_by_cylinder_v_x = (-(t12 * t424).add_product(m.factors[69], t425)
        .add_product(m.factors[69], t423)).add_product(t12, t422);
    let post_v_y_dot_by_cylinder_v_x = (R::literal(1.25) * t422).add_product(R::literal(1.25),
        t424);
    let post_v_x_dot_by_cylinder_v_x = (R::literal(1.25) * t423).add_product(R::literal(-1.25),
        t425);
    let t427 = m.factors[4] * t115;
    let t428 = t398 - t427;
    let t429 = R::literal(3.333_333_333_333_333_5) * t114;
    let t430 = t429.add_product(t16, t115);
    let t431 = t430.add_product(t24, t428);
    let t432 = R::literal(-2_777.777_777_777_778) * t115;
    let t433 = t432.add_product(m.factors[12], t428).add_product(m.factors[13], t431);
    let t434 = m.factors[14] * t109;
    let t435 = t15 * t114;
    let t436 = t17 * t115;
    let t437 = t18 * t109;
    let t438 = m.factors[18] * t114;
    let t439 = (t434 - t116 - t435 + t436 + t437 - t438).add_product(m.t97, t428)
        .sub_product(m.factors[20], t431).sub_product(t26, t433);
    let t440 = (-t411).add_product(m.factors[23], t433).sub_product(m.factors[24], t439);
    let t441 = R::literal(5.0) * t114;
    let t442 = (-t441.add_product(t27, t433)).add_product(m.t135, t439).add_product(m.t146, t440);
    let t443 = (t25 * t428).sub_product(m.factors[33], t431).sub_product(t28, t433)
        .sub_product(m.factors[35], t439).add_product(t30, t440).sub_product(m.factors[37], t442);
    let t444 = (m.t103 * t428).sub_product(m.factors[42], t431).sub_product(t29, t433)
        .sub_product(m.factors[44], t439).add_product(t31, t440).sub_product(m.factors[46], t442)
        .sub_product(m.factors[47], t443) * m.factors[48];
    let t445 = (t443 * m.factors[49]).sub_product(m.factors[47], t444);
    let t446 = (t442 * m.factors[50]).sub_product(m.factors[37], t445).sub_product(m.factors[46],
        t444);
    let t447 = (-(t440 * m.t143)).add_product(m.t146, t446).add_product(t30, t445).add_product(t31,
        t444);
    let t448 = (t439 * m.factors[52]).sub_product(m.factors[24], t447).add_product(m.t135, t446)
        .sub_product(m.factors[35], t445).sub_product(m.factors[44], t444);
    let t449 = (-(t433 * m.factors[53])).add_product(t26, t448).sub_product(m.factors[23], t447)
        .add_product(t27, t446).add_product(t28, t445).add_product(t29, t444);
    let t450 = (t431 * m.factors[54]).sub_product(m.factors[13], t449).sub_product(m.factors[20],
        t448).sub_product(m.factors[33], t445).sub_product(m.factors[42], t444);
    let t451 = (-(t428 * m.t89)).add_product(t24, t450).sub_product(m.factors[12], t449)
        .add_product(m.t97, t448).add_product(t25, t445).add_product(m.t103, t444);
    let t452 = (-(m.factors[9] * t450).add_product(m.factors[6], t451)).add_product(t23, t445)
        .sub_product(m.factors[40], t444);
    let t453 = (-(m.factors[5] * t451).add_product(m.factors[2], t452).add_product(m.factors[8],
        t450).add_product(m.factors[30], t445)).add_product(t22, t444);
    let t454 = (m.factors[59] * t452).add_product(m.factors[58], t453);
    let t455 = (t21 * t453).sub_product(t20, t454).add_product(t20, t452);
    let bobbin_v_y_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t444;
    let bobbin_v_x_dot_by_cylinder_v_y = R::literal(-1.428_571_428_571_428_6) * t445;
    let rod_omega_dot_by_cylinder_v_y = (t19 * t447).sub_product(R::literal(4_166.666_666_666_667),
        t449).sub_product(m.factors[64], t446);
    let rod_v_y_dot_by_cylinder_v_y = t441.sub_product(m.factors[18], t448)
        .sub_product(R::literal(5.0), t446);
    let rod_v_x_dot_by_cylinder_v_y = t411.add_product(t18, t448).sub_product(R::literal(5.0),
        t447);
    let t456 = t115 * R::literal(2_777.777_777_777_778);
    let cylinder_omega_dot_by_cylinder_v_y = t456.sub_product(m.factors[4], t451).add_product(t16,
        t450).sub_product(R::literal(-2_777.777_777_777_778), t449).add_product(t17, t448);
    let cylinder_v_y_dot_by_cylinder_v_y = (-t429.add_product(R::literal(3.333_333_333_333_333_5),
        t450)).add_product(t15, t448);
    let cylinder_v_x_dot_by_cylinder_v_y = (-t398)
        .add_product(R::literal(-3.333_333_333_333_333_5), t451).sub_product(m.factors[14], t448);
    let plate_omega_dot_by_cylinder_v_y = (t13 * t452).sub_product(m.factors[0], t453)
        .sub_product(m.factors[0], t451).add_product(t13, t450).add_product(t14, t445)
        .sub_product(m.factors[38], t444);
    let plate_v_y_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t450)
        .add_product(R::literal(-0.833_333_333_333_333_4), t452)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t444);
    let plate_v_x_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t451)
        .add_product(R::literal(-0.833_333_333_333_333_4), t453)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t445);
    let post_omega_dot_by_cylinder_v_y = (-(t12 * t454).add_product(m.factors[69], t455)
        .add_product(m.factors[69], t453)).add_product(t12, t452);
    let post_v_y_dot_by_cylinder_v_y = (R::literal(1.25) * t452).add_product(R::literal(1.25),
        t454);
    let post_v_x_dot_by_cylinder_v_y = (R::literal(1.25) * t453).add_product(R::literal(-1.25),
        t455);
    let t457 = R::literal(3.333_333_333_333_333_5) * t111;
    let t458 = (-t457.add_product(t118, m.cos_cylinder_phi)).add_product(m.factors[4], t117);
    let t459 = R::literal(3.333_333_333_333_333_5) * t115;
    let t460 = (-t459.add_product(t118, m.sin_cylinder_phi).add_product(t16, t117))
        .add_product(t24, t458);
    let t461 = (R::literal(-2_777.777_777_777_778) * t117).sub_product(m.factors[12], t458)
        .sub_product(m.factors[13], t460);
    let t462 = (R::literal(2.0) * cylinder_x * cylinder_omega * m.sin_cylinder_phi)
        .add_product(R::literal(2.0) * rod_y * cylinder_omega, m.cos_cylinder_phi).add_product(t39,
        m.cos_cylinder_phi).add_product(t40, m.sin_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_y * cylinder_omega, m.cos_cylinder_phi).sub_product(R::literal(2.0) * rod_x
        * cylinder_omega, m.sin_cylinder_phi).sub_product(t37, m.cos_cylinder_phi).sub_product(t38,
        m.sin_cylinder_phi).sub_product(m.factors[14], t111).add_product(t15, t115)
        .sub_product(t17, t117).sub_product(t18, t111).add_product(m.factors[18], t115)
        .add_product(m.t97, t458).sub_product(m.factors[20], t460).add_product(t26, t461);
    let t463 = R::literal(5.0) * t111;
    let t464 = t463.sub_product(m.factors[23], t461).sub_product(m.factors[24], t462);
    let t465 = R::literal(5.0) * t115;
    let t466 = t465.add_product(t27, t461).add_product(m.t135, t462).add_product(m.t146, t464);
    let t467 = (t25 * t458).sub_product(m.factors[33], t460).add_product(t28, t461)
        .sub_product(m.factors[35], t462).add_product(t30, t464).sub_product(m.factors[37], t466);
    let t468 = (m.t103 * t458).sub_product(m.factors[42], t460).add_product(t29, t461)
        .sub_product(m.factors[44], t462).add_product(t31, t464).sub_product(m.factors[46], t466)
        .sub_product(m.factors[47], t467) * m.factors[48];
    let t469 = (t467 * m.factors[49]).sub_product(m.factors[47], t468);
    let t470 = (t466 * m.factors[50]).sub_product(m.factors[37], t469).sub_product(m.factors[46],
        t468);
    let t471 = (-(t464 * m.t143)).add_product(m.t146, t470).add_product(t30, t469).add_product(t31,
        t468);
    let t472 = (t462 * m.factors[52]).sub_product(m.factors[24], t471).add_product(m.t135, t470)
        .sub_product(m.factors[35], t469).sub_product(m.factors[44], t468);
    let t473 = (t461 * m.factors[53]).add_product(t26, t472).sub_product(m.factors[23], t471)
        .add_product(t27, t470).add_product(t28, t469).add_product(t29, t468);
    let t474 = (t460 * m.factors[54]).sub_product(m.factors[13], t473).sub_product(m.factors[20],
        t472).sub_product(m.factors[33], t469).sub_product(m.factors[42], t468);
    let t475 = (-(t458 * m.t89)).add_product(t24, t474).sub_product(m.factors[12], t473)
        .add_product(m.t97, t472).add_product(t25, t469).add_product(m.t103, t468);
    let t476 = (-(m.factors[9] * t474).add_product(m.factors[6], t475)).add_product(t23, t469)
        .sub_product(m.factors[40], t468);
    let t477 = (-(m.factors[5] * t475).add_product(m.factors[2], t476).add_product(m.factors[8],
        t474).add_product(m.factors[30], t469)).add_product(t22, t468);
    let t478 = (m.factors[59] * t476).add_product(m.factors[58], t477);
    let t479 = (t21 * t477).sub_product(t20, t478).add_product(t20, t476);
    let bobbin_v_y_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t468;
    let bobbin_v_x_dot_by_cylinder_omega = R::literal(-1.428_571_428_571_428_6) * t469;
    let rod_omega_dot_by_cylinder_omega = (t19 * t471)
        .sub_product(R::literal(4_166.666_666_666_667), t473).sub_product(m.factors[64], t470);
    let rod_v_y_dot_by_cylinder_omega = (-t465.add_product(m.factors[18], t472))
        .add_product(R::literal(-5.0), t470);
    let rod_v_x_dot_by_cylinder_omega = (-t463).add_product(t18, t472).sub_product(R::literal(5.0),
        t471);
    let cylinder_omega_dot_by_cylinder_omega = (-(t117 * R::literal(2_777.777_777_777_778))
        .add_product(m.factors[4], t475)).add_product(t16, t474)
        .sub_product(R::literal(-2_777.777_777_777_778), t473).add_product(t17, t472);
    let cylinder_v_y_dot_by_cylinder_omega = t459.sub_product(R::literal(3.333_333_333_333_333_5),
        t474).add_product(t15, t472);
    let cylinder_v_x_dot_by_cylinder_omega = t457.sub_product(R::literal(3.333_333_333_333_333_5),
        t475).sub_product(m.factors[14], t472);
    let plate_omega_dot_by_cylinder_omega = (t13 * t476).sub_product(m.factors[0], t477)
        .sub_product(m.factors[0], t475).add_product(t13, t474).add_product(t14, t469)
        .sub_product(m.factors[38], t468);
    let plate_v_y_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t474)
        .add_product(R::literal(-0.833_333_333_333_333_4), t476)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t468);
    let plate_v_x_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t475)
        .add_product(R::literal(-0.833_333_333_333_333_4), t477)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t469);
    let post_omega_dot_by_cylinder_omega = (-(t12 * t478).add_product(m.factors[69], t479)
        .add_product(m.factors[69], t477)).add_product(t12, t476);
    let post_v_y_dot_by_cylinder_omega = (R::literal(1.25) * t476).add_product(R::literal(1.25),
        t478);
    let post_v_x_dot_by_cylinder_omega = (R::literal(1.25) * t477).add_product(R::literal(-1.25),
        t479);
    let t480 = t396 - t395;
    let t481 = (-t399).add_product(t24, t480);
    let t482 = t401.sub_product(m.factors[12], t480).sub_product(m.factors[13], t481);
    let t483 = (t113 - t403 + t404 - t405 - t406 + t407).add_product(m.t97, t480)
        .sub_product(m.factors[20], t481).add_product(t26, t482);
    let t484 = t409.sub_product(m.factors[23], t482).sub_product(m.factors[24], t483);
    let t485 = t411.add_product(t27, t482).add_product(m.t135, t483).add_product(m.t146, t484);
    let t486 = (t25 * t480).sub_product(m.factors[33], t481).add_product(t28, t482)
        .sub_product(m.factors[35], t483).add_product(t30, t484).sub_product(m.factors[37], t485);
    let t487 = (m.t103 * t480).sub_product(m.factors[42], t481).add_product(t29, t482)
        .sub_product(m.factors[44], t483).add_product(t31, t484).sub_product(m.factors[46], t485)
        .sub_product(m.factors[47], t486) * m.factors[48];
    let t488 = (t486 * m.factors[49]).sub_product(m.factors[47], t487);
    let t489 = (t485 * m.factors[50]).sub_product(m.factors[37], t488).sub_product(m.factors[46],
        t487);
    let t490 = (-(t484 * m.t143)).add_product(m.t146, t489).add_product(t30, t488).add_product(t31,
        t487);
    let t491 = (t483 * m.factors[52]).sub_product(m.factors[24], t490).add_product(m.t135, t489)
        .sub_product(m.factors[35], t488).sub_product(m.factors[44], t487);
    let t492 = (t482 * m.factors[53]).add_product(t26, t491).sub_product(m.factors[23], t490)
        .add_product(t27, t489).add_product(t28, t488).add_product(t29, t487);
    let t493 = (t481 * m.factors[54]).sub_product(m.factors[13], t492).sub_product(m.factors[20],
        t491).sub_product(m.factors[33], t488).sub_product(m.factors[42], t487);
    let t494 = (-(t480 * m.t89)).add_product(t24, t493).sub_product(m.factors[12], t492)
        .add_product(m.t97, t491).add_product(t25, t488).add_product(m.t103, t487);
    let t495 = (-(m.factors[9] * t493).add_product(m.factors[6], t494)).add_product(t23, t488)
        .sub_product(m.factors[40], t487);
    let t496 = (-(m.factors[5] * t494).add_product(m.factors[2], t495).add_product(m.factors[8],
        t493).add_product(m.factors[30], t488)).add_product(t22, t487);
    let t497 = (m.factors[59] * t495).add_product(m.factors[58], t496);
    let t498 = (t21 * t496).sub_product(t20, t497).add_product(t20, t495);
    let bobbin_v_y_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t487;
    let bobbin_v_x_dot_by_rod_v_x = R::literal(-1.428_571_428_571_428_6) * t488;
    let rod_omega_dot_by_rod_v_x = (t19 * t490).sub_product(R::literal(4_166.666_666_666_667), t492)
        .sub_product(m.factors[64], t489);
    let rod_v_y_dot_by_rod_v_x = (-t411.add_product(m.factors[18], t491))
        .add_product(R::literal(-5.0), t489);
    let rod_v_x_dot_by_rod_v_x = (-t409).add_product(t18, t491).sub_product(R::literal(5.0), t490);
    let cylinder_omega_dot_by_rod_v_x = (-t426.add_product(m.factors[4], t494)).add_product(t16,
        t493).sub_product(R::literal(-2_777.777_777_777_778), t492).add_product(t17, t491);
    let cylinder_v_y_dot_by_rod_v_x = t398.sub_product(R::literal(3.333_333_333_333_333_5), t493)
        .add_product(t15, t491);
    let cylinder_v_x_dot_by_rod_v_x = t395.sub_product(R::literal(3.333_333_333_333_333_5), t494)
        .sub_product(m.factors[14], t491);
    let plate_omega_dot_by_rod_v_x = (t13 * t495).sub_product(m.factors[0], t496)
        .sub_product(m.factors[0], t494).add_product(t13, t493).add_product(t14, t488)
        .sub_product(m.factors[38], t487);
    let plate_v_y_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t493)
        .add_product(R::literal(-0.833_333_333_333_333_4), t495)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t487);
    let plate_v_x_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t494)
        .add_product(R::literal(-0.833_333_333_333_333_4), t496)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t488);
    let post_omega_dot_by_rod_v_x = (-(t12 * t497).add_product(m.factors[69], t498)
        .add_product(m.factors[69], t496)).add_product(t12, t495);
    let post_v_y_dot_by_rod_v_x = (R::literal(1.25) * t495).add_product(R::literal(1.25), t497);
    let post_v_x_dot_by_rod_v_x = (R::literal(1.25) * t496).add_product(R::literal(-1.25), t498);
    let t499 = t427 - t398;
    let t500 = (-t430).add_product(t24, t499);
    let t501 = t432.sub_product(m.factors[12], t499).sub_product(m.factors[13], t500);
    let t502 = (t116 - t434 + t435 - t436 - t437 + t438).add_product(m.t97, t499)
        .sub_product(m.factors[20], t500).add_product(t26, t501);
    let t503 = t411.sub_product(m.factors[23], t501).sub_product(m.factors[24], t502);
    let t504 = t441.add_product(t27, t501).add_product(m.t135, t502).add_product(m.t146, t503);
    let t505 = (t25 * t499).sub_product(m.factors[33], t500).add_product(t28, t501)
        .sub_product(m.factors[35], t502).add_product(t30, t503).sub_product(m.factors[37], t504);
    let t506 = (m.t103 * t499).sub_product(m.factors[42], t500).add_product(t29, t501)
        .sub_product(m.factors[44], t502).add_product(t31, t503).sub_product(m.factors[46], t504)
        .sub_product(m.factors[47], t505) * m.factors[48];
    let t507 = (t505 * m.factors[49]).sub_product(m.factors[47], t506);
    let t508 = (t504 * m.factors[50]).sub_product(m.factors[37], t507).sub_product(m.factors[46],
        t506);
    let t509 = (-(t503 * m.t143)).add_product(m.t146, t508).add_product(t30, t507).add_product(t31,
        t506);
    let t510 = (t502 * m.factors[52]).sub_product(m.factors[24], t509).add_product(m.t135, t508)
        .sub_product(m.factors[35], t507).sub_product(m.factors[44], t506);
    let t511 = (t501 * m.factors[53]).add_product(t26, t510).sub_product(m.factors[23], t509)
        .add_product(t27, t508).add_product(t28, t507).add_product(t29, t506);
    let t512 = (t500 * m.factors[54]).sub_product(m.factors[13], t511).sub_product(m.factors[20],
        t510).sub_product(m.factors[33], t507).sub_product(m.factors[42], t506);
    let t513 = (-(t499 * m.t89)).add_product(t24, t512).sub_product(m.factors[12], t511)
        .add_product(m.t97, t510).add_product(t25, t507).add_product(m.t103, t506);
    let t514 = (-(m.factors[9] * t512).add_product(m.factors[6], t513)).add_product(t23, t507)
        .sub_product(m.factors[40], t506);
    let t515 = (-(m.factors[5] * t513).add_product(m.factors[2], t514).add_product(m.factors[8],
        t512).add_product(m.factors[30], t507)).add_product(t22, t506);
    let t516 = (m.factors[59] * t514).add_product(m.factors[58], t515);
    let t517 = (t21 * t515).sub_product(t20, t516).add_product(t20, t514);
    let bobbin_v_y_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t506;
    let bobbin_v_x_dot_by_rod_v_y = R::literal(-1.428_571_428_571_428_6) * t507;
    let rod_omega_dot_by_rod_v_y = (t19 * t509).sub_product(R::literal(4_166.666_666_666_667), t511)
        .sub_product(m.factors[64], t508);
    let rod_v_y_dot_by_rod_v_y = (-t441.add_product(m.factors[18], t510))
        .add_product(R::literal(-5.0), t508);
    let rod_v_x_dot_by_rod_v_y = (-t411).add_product(t18, t510).sub_product(R::literal(5.0), t509);
    let cylinder_omega_dot_by_rod_v_y = (-t456.add_product(m.factors[4], t513)).add_product(t16,
        t512).sub_product(R::literal(-2_777.777_777_777_778), t511).add_product(t17, t510);
    let cylinder_v_y_dot_by_rod_v_y = t429.sub_product(R::literal(3.333_333_333_333_333_5), t512)
        .add_product(t15, t510);
    let cylinder_v_x_dot_by_rod_v_y = t398.sub_product(R::literal(3.333_333_333_333_333_5), t513)
        .sub_product(m.factors[14], t510);
    let plate_omega_dot_by_rod_v_y = (t13 * t514).sub_product(m.factors[0], t515)
        .sub_product(m.factors[0], t513).add_product(t13, t512).add_product(t14, t507)
        .sub_product(m.factors[38], t506);
    let plate_v_y_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t512)
        .add_product(R::literal(-0.833_333_333_333_333_4), t514)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t506);
    let plate_v_x_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t513)
        .add_product(R::literal(-0.833_333_333_333_333_4), t515)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t507);
    let post_omega_dot_by_rod_v_y = (-(t12 * t516).add_product(m.factors[69], t517)
        .add_product(m.factors[69], t515)).add_product(t12, t514);
    let post_v_y_dot_by_rod_v_y = (R::literal(1.25) * t514).add_product(R::literal(1.25), t516);
    let post_v_x_dot_by_rod_v_y = (R::literal(1.25) * t515).add_product(R::literal(-1.25), t517);
    let t518 = (t119 * m.sin_rod_phi).add_product(m.t146, t120);
    let t519 = (t30 * t120).sub_product(m.factors[37], t518);
    let t520 = (t31 * t120).sub_product(m.factors[46], t518).sub_product(m.factors[47], t519)
        * m.factors[48];
    let t521 = (t519 * m.factors[49]).sub_product(m.factors[47], t520);
    let t522 = (t518 * m.factors[50]).sub_product(m.factors[37], t521).sub_product(m.factors[46],
        t520);
    let t523 = (-(t120 * m.t143)).add_product(m.t146, t522).add_product(t30, t521).add_product(t31,
        t520);
    let t524 = (m.t135 * t522).sub_product(m.factors[24], t523).sub_product(m.factors[35], t521)
        .sub_product(m.factors[44], t520);
    let t525 = (-(m.factors[23] * t523)).add_product(t26, t524).add_product(t27, t522)
        .add_product(t28, t521).add_product(t29, t520);
    let t526 = (m.factors[20] * t524).add_product(m.factors[13], t525).add_product(m.factors[33],
        t521).add_product(m.factors[42], t520);
    let t527 = (-(m.factors[12] * t525).add_product(t24, t526)).add_product(m.t97, t524)
        .add_product(t25, t521).add_product(m.t103, t520);
    let t528 = (m.factors[9] * t526).sub_product(m.factors[6], t527).add_product(t23, t521)
        .sub_product(m.factors[40], t520);
    let t529 = (-(m.factors[5] * t527).add_product(m.factors[2], t528)).add_product(m.factors[8],
        t526).sub_product(m.factors[30], t521).add_product(t22, t520);
    let t530 = (m.factors[59] * t528).add_product(m.factors[58], t529);
    let t531 = (t21 * t529).sub_product(t20, t530).add_product(t20, t528);
    let bobbin_v_y_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t520;
    let bobbin_v_x_dot_by_rod_omega = R::literal(-1.428_571_428_571_428_6) * t521;
    let rod_omega_dot_by_rod_omega = (t19 * t523).sub_product(R::literal(4_166.666_666_666_667),
        t525).sub_product(m.factors[64], t522);
    let rod_v_y_dot_by_rod_omega = (R::literal(-5.0) * t522).sub_product(m.factors[18], t524);
    let rod_v_x_dot_by_rod_omega = (R::literal(-5.0) * t523).add_product(t18, t524);
    let cylinder_omega_dot_by_rod_omega = (-(t16 * t526).add_product(m.factors[4], t527)
        .add_product(R::literal(-2_777.777_777_777_778), t525)).add_product(t17, t524);
    let cylinder_v_y_dot_by_rod_omega = (t15 * t524)
        .add_product(R::literal(3.333_333_333_333_333_5), t526);
    let cylinder_v_x_dot_by_rod_omega = (-(m.factors[14] * t524))
        .add_product(R::literal(-3.333_333_333_333_333_5), t527);
    let plate_omega_dot_by_rod_omega = (t13 * t528).sub_product(m.factors[0], t529)
        .sub_product(m.factors[0], t527).sub_product(t13, t526).add_product(t14, t521)
        .sub_product(m.factors[38], t520);
    let plate_v_y_dot_by_rod_omega = (R::literal(-0.833_333_333_333_333_4) * t526)
        .sub_product(R::literal(0.833_333_333_333_333_4), t528)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t520);
    let plate_v_x_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t527)
        .add_product(R::literal(-0.833_333_333_333_333_4), t529)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t521);
    let post_omega_dot_by_rod_omega = (-(t12 * t530).add_product(m.factors[69], t531)
        .add_product(m.factors[69], t529)).add_product(t12, t528);
    let post_v_y_dot_by_rod_omega = (R::literal(1.25) * t528).add_product(R::literal(1.25), t530);
    let post_v_x_dot_by_rod_omega = (R::literal(1.25) * t529).add_product(R::literal(-1.25), t531);
    let t532 = m.factors[0] * t122;
    let t533 = t13 * t122;
    let t534 = t533.add_product(m.factors[2], t532);
    let t535 = (-t532).add_product(m.factors[5], t532).sub_product(m.factors[6], t534);
    let t536 = t533.add_product(m.factors[8], t532).sub_product(m.factors[9], t534)
        .add_product(t24, t535);
    let t537 = (m.factors[12] * t535).add_product(m.factors[13], t536);
    let t538 = (m.t97 * t535).sub_product(m.factors[20], t536).sub_product(t26, t537);
    let t539 = (m.factors[23] * t537).sub_product(m.factors[24], t538);
    let t540 = (-(t27 * t537)).add_product(m.t135, t538).add_product(m.t146, t539);
    let t541 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), t123 - p.contact_damping * m.t9 / t86);
    let t542 = (-t541).add_product(t14, t122).add_product(m.factors[30], t532).add_product(t23,
        t534).add_product(t25, t535).sub_product(m.factors[33], t536).sub_product(t28, t537)
        .sub_product(m.factors[35], t538).add_product(t30, t539).sub_product(m.factors[37], t540);
    let t543 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(c.grip_times_contact_damping * m.t9 / t86 + t124));
    let t544 = (-t543.add_product(m.factors[38], t122).add_product(t22, t532)
        .add_product(m.factors[40], t534)).add_product(m.t103, t535).sub_product(m.factors[42],
        t536).sub_product(t29, t537).sub_product(m.factors[44], t538).add_product(t31, t539)
        .sub_product(m.factors[46], t540).sub_product(m.factors[47], t542) * m.factors[48];
    let t545 = (t542 * m.factors[49]).sub_product(m.factors[47], t544);
    let t546 = (t540 * m.factors[50]).sub_product(m.factors[37], t545).sub_product(m.factors[46],
        t544);
    let t547 = (-(t539 * m.t143)).add_product(m.t146, t546).add_product(t30, t545).add_product(t31,
        t544);
    let t548 = (t538 * m.factors[52]).sub_product(m.factors[24], t547).add_product(m.t135, t546)
        .sub_product(m.factors[35], t545).sub_product(m.factors[44], t544);
    let t549 = (-(t537 * m.factors[53])).add_product(t26, t548).sub_product(m.factors[23], t547)
        .add_product(t27, t546).add_product(t28, t545).add_product(t29, t544);
    let t550 = (t536 * m.factors[54]).sub_product(m.factors[13], t549).sub_product(m.factors[20],
        t548).sub_product(m.factors[33], t545).sub_product(m.factors[42], t544);
    let t551 = (-(t535 * m.t89)).add_product(t24, t550).sub_product(m.factors[12], t549)
        .add_product(m.t97, t548).add_product(t25, t545).add_product(m.t103, t544);
    let t552 = (t534 * m.factors[56]).sub_product(m.factors[6], t551).sub_product(m.factors[9],
        t550).add_product(t23, t545).sub_product(m.factors[40], t544);
    let t553 = (-(t532 * m.factors[57]).add_product(m.factors[2], t552).add_product(m.factors[5],
        t551).add_product(m.factors[8], t550).add_product(m.factors[30], t545)).add_product(t22,
        t544);
    let t554 = (m.factors[59] * t552).add_product(m.factors[58], t553);
    let t555 = (t21 * t553).sub_product(t20, t554).add_product(t20, t552);
    let bobbin_v_y_dot_by_bobbin_v_x = t543.sub_product(R::literal(1.428_571_428_571_428_6), t544);
    let bobbin_v_x_dot_by_bobbin_v_x = t541.sub_product(R::literal(1.428_571_428_571_428_6), t545);
    let rod_omega_dot_by_bobbin_v_x = (t19 * t547).sub_product(R::literal(4_166.666_666_666_667),
        t549).sub_product(m.factors[64], t546);
    let rod_v_y_dot_by_bobbin_v_x = (R::literal(-5.0) * t546).sub_product(m.factors[18], t548);
    let rod_v_x_dot_by_bobbin_v_x = (R::literal(-5.0) * t547).add_product(t18, t548);
    let cylinder_omega_dot_by_bobbin_v_x = (t16 * t550).sub_product(m.factors[4], t551)
        .sub_product(R::literal(-2_777.777_777_777_778), t549).add_product(t17, t548);
    let cylinder_v_y_dot_by_bobbin_v_x = (t15 * t548)
        .sub_product(R::literal(3.333_333_333_333_333_5), t550);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(m.factors[14] * t548))
        .add_product(R::literal(-3.333_333_333_333_333_5), t551);
    let plate_omega_dot_by_bobbin_v_x = (t122 * R::literal(400.0)).sub_product(m.factors[0], t553)
        .add_product(t13, t552).sub_product(m.factors[0], t551).add_product(t13, t550)
        .add_product(t14, t545).sub_product(m.factors[38], t544);
    let plate_v_y_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t550)
        .add_product(R::literal(-0.833_333_333_333_333_4), t552)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t544);
    let plate_v_x_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t551)
        .add_product(R::literal(-0.833_333_333_333_333_4), t553)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t545);
    let post_omega_dot_by_bobbin_v_x = (-(t12 * t554).add_product(m.factors[69], t555)
        .add_product(m.factors[69], t553)).add_product(t12, t552);
    let post_v_y_dot_by_bobbin_v_x = (R::literal(1.25) * t552).add_product(R::literal(1.25), t554);
    let post_v_x_dot_by_bobbin_v_x = (R::literal(1.25) * t553).add_product(R::literal(-1.25), t555);
    let t556 = m.factors[0] * t125;
    let t557 = t13 * t125;
    let t558 = t557.add_product(m.factors[2], t556);
    let t559 = (-t556).add_product(m.factors[5], t556).sub_product(m.factors[6], t558);
    let t560 = t557.add_product(m.factors[8], t556).sub_product(m.factors[9], t558)
        .add_product(t24, t559);
    let t561 = (m.factors[12] * t559).add_product(m.factors[13], t560);
    let t562 = (m.t97 * t559).sub_product(m.factors[20], t560).sub_product(t26, t561);
    let t563 = (m.factors[23] * t561).sub_product(m.factors[24], t562);
    let t564 = (-(t27 * t561)).add_product(m.t135, t562).add_product(m.t146, t563);
    let t565 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), c.grip_times_contact_damping * m.t11 / t86 - t124);
    let t566 = (-t565).add_product(t14, t125).add_product(m.factors[30], t556).add_product(t23,
        t558).add_product(t25, t559).sub_product(m.factors[33], t560).sub_product(t28, t561)
        .sub_product(m.factors[35], t562).add_product(t30, t563).sub_product(m.factors[37], t564);
    let t567 = R::literal(1.428_571_428_571_428_6) * R::select_less(contact_closed,
        R::literal(0.5), R::literal(0.0), -(t123 + p.contact_damping * m.t11 / t86));
    let t568 = (-t567.add_product(m.factors[38], t125).add_product(t22, t556)
        .add_product(m.factors[40], t558)).add_product(m.t103, t559).sub_product(m.factors[42],
        t560).sub_product(t29, t561).sub_product(m.factors[44], t562).add_product(t31, t563)
        .sub_product(m.factors[46], t564).sub_product(m.factors[47], t566) * m.factors[48];
    let t569 = (t566 * m.factors[49]).sub_product(m.factors[47], t568);
    let t570 = (t564 * m.factors[50]).sub_product(m.factors[37], t569).sub_product(m.factors[46],
        t568);
    let t571 = (-(t563 * m.t143)).add_product(m.t146, t570).add_product(t30, t569).add_product(t31,
        t568);
    let t572 = (t562 * m.factors[52]).sub_product(m.factors[24], t571).add_product(m.t135, t570)
        .sub_product(m.factors[35], t569).sub_product(m.factors[44], t568);
    let t573 = (-(t561 * m.factors[53])).add_product(t26, t572).sub_product(m.factors[23], t571)
        .add_product(t27, t570).add_product(t28, t569).add_product(t29, t568);
    let t574 = (t560 * m.factors[54]).sub_product(m.factors[13], t573).sub_product(m.factors[20],
        t572).sub_product(m.factors[33], t569).sub_product(m.factors[42], t568);
    let t575 = (-(t559 * m.t89)).add_product(t24, t574).sub_product(m.factors[12], t573)
        .add_product(m.t97, t572).add_product(t25, t569).add_product(m.t103, t568);
    let t576 = (t558 * m.factors[56]).sub_product(m.factors[6], t575).sub_product(m.factors[9],
        t574).add_product(t23, t569).sub_product(m.factors[40], t568);
    let t577 = (-(t556 * m.factors[57]).add_product(m.factors[2], t576).add_product(m.factors[5],
        t575).add_product(m.factors[8], t574).add_product(m.factors[30], t569)).add_product(t22,
        t568);
    let t578 = (m.factors[59] * t576).add_product(m.factors[58], t577);
    let t579 = (t21 * t577).sub_product(t20, t578).add_product(t20, t576);
    let bobbin_v_y_dot_by_bobbin_v_y = t567.sub_product(R::literal(1.428_571_428_571_428_6), t568);
    let bobbin_v_x_dot_by_bobbin_v_y = t565.sub_product(R::literal(1.428_571_428_571_428_6), t569);
    let rod_omega_dot_by_bobbin_v_y = (t19 * t571).sub_product(R::literal(4_166.666_666_666_667),
        t573).sub_product(m.factors[64], t570);
    let rod_v_y_dot_by_bobbin_v_y = (R::literal(-5.0) * t570).sub_product(m.factors[18], t572);
    let rod_v_x_dot_by_bobbin_v_y = (R::literal(-5.0) * t571).add_product(t18, t572);
    let cylinder_omega_dot_by_bobbin_v_y = (t16 * t574).sub_product(m.factors[4], t575)
        .sub_product(R::literal(-2_777.777_777_777_778), t573).add_product(t17, t572);
    let cylinder_v_y_dot_by_bobbin_v_y = (t15 * t572)
        .sub_product(R::literal(3.333_333_333_333_333_5), t574);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(m.factors[14] * t572))
        .add_product(R::literal(-3.333_333_333_333_333_5), t575);
    let plate_omega_dot_by_bobbin_v_y = (t125 * R::literal(400.0)).sub_product(m.factors[0], t577)
        .add_product(t13, t576).sub_product(m.factors[0], t575).add_product(t13, t574)
        .add_product(t14, t569).sub_product(m.factors[38], t568);
    let plate_v_y_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t574)
        .add_product(R::literal(-0.833_333_333_333_333_4), t576)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t568);
    let plate_v_x_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t575)
        .add_product(R::literal(-0.833_333_333_333_333_4), t577)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t569);
    let post_omega_dot_by_bobbin_v_y = (-(t12 * t578).add_product(m.factors[69], t579)
        .add_product(m.factors[69], t577)).add_product(t12, t576);
    let post_v_y_dot_by_bobbin_v_y = (R::literal(1.25) * t576).add_product(R::literal(1.25), t578);
    let post_v_x_dot_by_bobbin_v_y = (R::literal(1.25) * t577).add_product(R::literal(-1.25), t579);
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

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 86 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 70] {
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
    let t3 = (p.contact_stiffness * contact_gap).add_product(p.contact_damping, contact_rate);
    let t4 = between - R::literal(0.04);
    let t5 = slide - R::literal(0.116);
    let t6 = t5 * cos_cylinder_phi;
    let t7 = t5 * sin_cylinder_phi;
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let grip_times_contact_gap = p.grip * contact_gap;
    let grip_times_contact_rate = p.grip * contact_rate;
    let mut x = [[R::literal(0.0); 8]; 26];
    x[5][0] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t3 * t4);
    x[12][0] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t3 * t1 / between);
    x[13][0] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(t3 * t0 / between));
    x[6][1] = t6;
    x[7][1] = t7;
    x[8][1] = -(t5 * t2);
    x[9][1] = -t6;
    x[10][1] = -t7;
    x[6][2] = slide_rate_times_cos_cylinder_phi;
    x[7][2] = slide_rate_times_sin_cylinder_phi;
    x[8][2] = -(slide_rate * t2);
    x[9][2] = -slide_rate_times_cos_cylinder_phi;
    x[10][2] = -slide_rate_times_sin_cylinder_phi;
    x[5][3] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        grip_times_contact_gap * t4);
    x[12][3] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        grip_times_contact_gap * t1 / between - contact_gap * t0 / between);
    x[13][3] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(grip_times_contact_gap * t0 / between + contact_gap * t1 / between));
    x[5][4] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        grip_times_contact_rate * t4);
    x[12][4] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        grip_times_contact_rate * t1 / between - contact_rate * t0 / between);
    x[13][4] = R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
        -(grip_times_contact_rate * t0 / between + contact_rate * t1 / between));
    substitute(PARAMETER_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [x[0][0], x[0][1], x[0][2], x[0][3], x[0][4], x[1][0], x[1][1], x[1][2], x[1][3], x[1][4],
        x[2][0], x[2][1], x[2][2], x[2][3], x[2][4], x[3][0], x[3][1], x[3][2], x[3][3], x[3][4],
        x[4][0], x[4][1], x[4][2], x[4][3], x[4][4], x[5][0], x[5][1], x[5][2], x[5][3], x[5][4],
        x[6][0], x[6][1], x[6][2], x[6][3], x[6][4], x[7][0], x[7][1], x[7][2], x[7][3], x[7][4],
        x[8][0], x[8][1], x[8][2], x[8][3], x[8][4], x[9][0], x[9][1], x[9][2], x[9][3], x[9][4],
        x[10][0], x[10][1], x[10][2], x[10][3], x[10][4], x[11][0], x[11][1], x[11][2], x[11][3],
        x[11][4], x[12][0], x[12][1], x[12][2], x[12][3], x[12][4], x[13][0], x[13][1], x[13][2],
        x[13][3], x[13][4]]
}

static PARAMETER_JACOBIAN_STEPS: &[Step<'static>] = &[Step::less(16, &[(0, 5)]), Step::less(17,
    &[(1, 5), (2, 16)]), Step::less(18, &[(0, 5), (3, 6), (4, 8), (5, 16), (6, 17)]),
    Step::less(19, &[(1, 5), (3, 7), (7, 8), (8, 16), (9, 17), (10, 18)]), Step::less(20,
    &[(11, 8), (12, 18), (13, 19)]), Step::less(21, &[(14, 6), (15, 7), (16, 8), (17, 9), (18, 10),
    (19, 18), (20, 19), (21, 20)]), Step::less(22, &[(22, 9), (23, 20), (24, 21)]), Step::less(23,
    &[(22, 10), (25, 20), (26, 21), (27, 22)]), Step::less(24, &[(28, 5), (29, 12), (30, 16),
    (31, 17), (32, 18), (33, 19), (34, 20), (35, 21), (36, 22), (37, 23)]), Step::less(25,
    &[(38, 5), (29, 13), (39, 16), (40, 17), (41, 18), (42, 19), (43, 20), (44, 21), (45, 22),
    (46, 23), (47, 24)]), Step::scaled(25, 48, &[]), Step::scaled(24, 49, &[(47, 25)]),
    Step::scaled(23, 50, &[(37, 24), (46, 25)]), Step::scaled(22, 51, &[(27, 23), (36, 24),
    (45, 25)]), Step::scaled(21, 52, &[(24, 22), (26, 23), (35, 24), (44, 25)]), Step::scaled(20,
    53, &[(21, 21), (23, 22), (25, 23), (34, 24), (43, 25)]), Step::scaled(19, 54,
    &[(13, 20), (20, 21), (33, 24), (42, 25)]), Step::scaled(18, 55, &[(10, 19), (12, 20),
    (19, 21), (32, 24), (41, 25)]), Step::scaled(17, 56, &[(6, 18), (9, 19), (31, 24), (40, 25)]),
    Step::scaled(16, 57, &[(2, 17), (5, 18), (8, 19), (30, 24), (39, 25)]), Step::less(15,
    &[(58, 16), (59, 17)]), Step::less(14, &[(60, 15), (61, 16), (60, 17)]), Step::scaled(13, 29,
    &[(29, 25)]), Step::scaled(12, 29, &[(29, 24)]), Step::less(11, &[(62, 20), (63, 22),
    (64, 23)]), Step::scaled(10, 22, &[(18, 21), (22, 23)]), Step::scaled(9, 22,
    &[(17, 21), (22, 22)]), Step::scaled(8, 65, &[(4, 18), (7, 19), (11, 20), (16, 21)]),
    Step::scaled(7, 3, &[(3, 19), (15, 21)]), Step::scaled(6, 3, &[(3, 18), (14, 21)]),
    Step::scaled(5, 66, &[(0, 16), (1, 17), (0, 18), (1, 19), (28, 24), (38, 25)]), Step::less(4,
    &[(67, 17), (68, 19), (68, 25)]), Step::less(3, &[(67, 16), (68, 18), (68, 24)]), Step::less(2,
    &[(69, 14), (70, 15), (69, 16), (70, 17)]), Step::less(1, &[(71, 15), (72, 17)]), Step::less(0,
    &[(71, 14), (72, 16)])];
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 124 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, _, _, _, _, _, _, _, _, _, _, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega,
        plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let stop_rate = post_omega * m.t7;
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let t2 = (R::literal(7.848) * post_v_y).add_product(R::select_less(stop_closed,
        R::literal(0.5), R::literal(0.0), R::literal(1_000_000.0) * m.stop_gap * m.t7), post_omega)
        .add_product(R::literal(11.772), plate_v_y).sub_product(m.t170, cylinder_v_x)
        .add_product(R::literal(2.943) - m.t172, cylinder_v_y).add_product(m.t175, cylinder_omega)
        .add_product(m.t170, rod_v_x).add_product(R::literal(1.962) + m.t172, rod_v_y)
        .add_product(R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t180),
        bobbin_v_x).add_product(R::literal(6.867) + R::select_less(contact_closed, R::literal(0.5),
        R::literal(0.0), m.t182), bobbin_v_y).sub_product(R::literal(0.8) * post_v_x, m.t248)
        .sub_product(R::literal(0.8) * post_v_y, m.t247).add_product(R::literal(0.0027)
        * post_omega, m.post_omega_dot);
    let t3 = (p.spring_damping * cylinder_omega * m.slide_rate * m.t12)
        .add_product(p.spring_damping * rod_v_x * m.slide_rate, m.cos_cylinder_phi)
        .add_product(p.spring_damping * rod_v_y * m.slide_rate, m.sin_cylinder_phi)
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), p.contact_damping
        * bobbin_v_x * m.contact_rate * t0 / m.between + p.contact_damping * bobbin_v_y
        * m.contact_rate * t1 / m.between) + R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), R::literal(1500.0) * (stop_rate * stop_rate));
    PowerBalance {
        stored_rate: t2.sub_product(R::literal(1.2) * plate_v_x, m.t246
            .add_product(R::literal(-0.833_333_333_333_333_4), m.t221)).sub_product(R::literal(1.2)
            * plate_v_y, m.t244 + m.t245).add_product(R::literal(0.0025) * plate_omega,
            m.plate_omega_dot).add_product(R::literal(0.3) * cylinder_v_x, m.cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, m.cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, m.cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, m.rod_v_x_dot).sub_product(R::literal(0.2)
            * rod_v_y, m.t243).add_product(R::literal(0.00024) * rod_omega, m.rod_omega_dot)
            .add_product(R::literal(0.7) * bobbin_v_x, m.bobbin_v_x_dot)
            .add_product(R::literal(0.7) * bobbin_v_y, m.bobbin_v_y_dot),
        supplied: R::select_less(contact_closed, R::literal(0.5), R::literal(0.0),
            (-(p.grip * bobbin_v_y * m.t13 * t0 / m.between)).add_product(p.grip * plate_omega
            * m.t13, m.between - R::literal(0.04)) + p.grip * bobbin_v_x * m.t13 * t1 / m.between),
        dissipated: t3.sub_product(p.spring_damping * cylinder_v_x * m.slide_rate,
            m.cos_cylinder_phi).sub_product(p.spring_damping * cylinder_v_y * m.slide_rate,
            m.sin_cylinder_phi),
    }
}

/// What passes zero where events happen, one for each event. 33 operations.
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
    let stop_contact = R::select_less(t3 + p.held_1, stop_push, t3, stop_push);
    let contact_contact = R::select_less(t4 + p.held_2, contact_push, t4, contact_push);
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
    let stop_push = -t2.add_product(R::literal(1500.0), stop_rate);
    let contact_push = -m.t13;
    let t3 = p.contact_stiffness * t0 / m.between;
    let t4 = m.between * m.between;
    let t5 = p.contact_stiffness * t1 / m.between;
    let t6 = p.held_2.sub_product(p.contact_stiffness, contact_gap);
    let t7 = (R::select_less(t6, contact_push, -t3, m.t181 / t4 - p.contact_damping * bobbin_v_x
        / m.between - t3) * bobbin_v_x).add_product(R::select_less(t6, contact_push, -t5, m.t183
        / t4 - p.contact_damping * bobbin_v_y / m.between - t5), bobbin_v_y)
        .add_product(R::select_less(t6, contact_push, R::literal(0.0), -(p.contact_damping * t0
        / m.between)), m.bobbin_v_x_dot);
    let contact_touches_guard_rate = t7.add_product(R::select_less(t6, contact_push,
        R::literal(0.0), -(p.contact_damping * t1 / m.between)), m.bobbin_v_y_dot);
    let t8 = R::literal(1_000_000.0) * m.t7;
    let t9 = -t2 + p.held_1;
    let stop_touches_guard_rate = (R::select_less(t9, stop_push, -t8, (-t8)
        .add_product(R::literal(1500.0) * post_omega, m.stop_gap)) * post_omega)
        .add_product(R::select_less(t9, stop_push, R::literal(0.0), R::literal(-1500.0) * m.t7),
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

/// What passes zero where the rate has a kink or a jump: arguments of `abs` and `sign`, differences
/// of what `min` and `max` compare, ends of tables. 28 operations.
#[must_use]
pub fn kink_guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; KINKS] {
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
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let kink_1 = t2.add_product(R::literal(1500.0), stop_rate) - t2;
    let kink_2 = contact_stiffness_times_contact_gap.add_product(p.contact_damping, contact_rate)
        - contact_stiffness_times_contact_gap;
    [kink_1, kink_2]
}

/// Rates along the motion of what passes zero at kinks. 39 operations.
#[must_use]
pub fn kink_rates<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; KINKS] {
    let bobbin_x = state[12];
    let bobbin_y = state[13];
    let post_omega = state[16];
    let bobbin_v_x = state[26];
    let bobbin_v_y = state[27];
    let m = &motion(time, state, p, &prepare(p));
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let t2 = bobbin_v_x * t0;
    let t3 = bobbin_v_y * t1;
    let t4 = m.sin_post_phi * post_omega;
    let t5 = m.cos_post_phi * post_omega;
    let t6 = R::literal(1.0) / (R::literal(2.0) * m.between) * (t2 + t2 + (t3 + t3));
    let t7 = R::literal(1_000_000.0) * (R::literal(0.143) * t5).add_product(R::literal(0.044), t4);
    let t8 = p.contact_stiffness * t6;
    let kink_rate_1 = t7.add_product(R::literal(1500.0), (m.post_omega_dot * m.t7)
        .add_product(post_omega, (R::literal(0.044) * t5).sub_product(R::literal(0.143), t4))) - t7;
    let kink_rate_2 = t8.add_product(p.contact_damping, ((bobbin_v_x * bobbin_v_x)
        .add_product(m.bobbin_v_x_dot, t0) + (bobbin_v_y * bobbin_v_y)
        .add_product(m.bobbin_v_y_dot, t1)).sub_product(m.contact_rate, t6) / m.between) - t8;
    [kink_rate_1, kink_rate_2]
}
