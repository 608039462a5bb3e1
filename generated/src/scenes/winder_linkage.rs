// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   120b1ba44467c8ceabf41e750243675fcf7e8b929410472d7b03d182240d9ef0  scenes/winder_linkage.toml
//   9870540d48dd190f3f4e3c2fea172f613c63b75b8e7bdb1d3432a0e230aaf646  units/planar_body.toml
//   c54202922c084fa221d54078498bfb0106d6b12d47343c2f291d70c177b5ce3c  units/spring_damper.toml
//
// Four-link bobbin holder, working position
//
// The holder of a self-twist spinning machine: post OC, plate ACD that carries the bobbin at A, and
// strut D-S-E, a spring and an oil damper in a cylinder that slides on a rod. The bobbin rests on the
// drum at K, the post on a stop at T. All six bodies are free in the plane. Fourteen constraints of
// pins and slide hold them, and two of the contacts, whose forces are N and Q. The holder works
// steadily while both forces are above zero.
//
// The study gives no dimensions, masses or stiffnesses; these are ours.
//
// Source:
//   Winder study, figures 2 and 3 and its table of links and pairs; every dimension, mass and stiffness is ours.
//
// All quantities are in SI units.
// Shapes: coordinates 18, states 36, parameters 5, outputs 7, constraints 16.
// Nonzeros: mass_matrix 18 of 18 by 18, rate_jacobian 228 of 36 by 36,
//     parameter_jacobian 0 of 36 by 5, constraint_matrix 44 of 16 by 18.
// Operations: rate 450, forcing 49, rate_jacobian 415, outputs 234, energy 72, power_balance 114,
//     constraint_values 62, constraint_rates 89, constraint_matrix 43, prepare 1, prepared_rate 449,
//     prepared_rate_jacobian 415, motion 466.

use ::machinist_contract::{Energy, PowerBalance, Real, implicit::{Step, substitute}};

::machinist_contract::simulator! {
    /// Four-link bobbin holder, working position
    ///
    /// The holder of a self-twist spinning machine: post OC, plate ACD that carries the bobbin at A, and
    /// strut D-S-E, a spring and an oil damper in a cylinder that slides on a rod. The bobbin rests on the
    /// drum at K, the post on a stop at T. All six bodies are free in the plane. Fourteen constraints of
    /// pins and slide hold them, and two of the contacts, whose forces are N and Q. The holder works
    /// steadily while both forces are above zero.
    ///
    /// The study gives no dimensions, masses or stiffnesses; these are ours.
    ///
    /// Source: Winder study, figures 2 and 3 and its table of links and pairs; every dimension, mass and stiffness is ours.
    WinderLinkage: "winder_linkage", "Four-link bobbin holder, working position";
    run from 0.0, until 1.0, points 101, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared; jacobians_apart;
}

::machinist_contract::parameters! {
    bobbin_radius: 0.06, "m", "bobbin_radius", "radius of the package on the bobbin";
    winding_force: 0.0, "N", "winding_force", "tangential force of the drum on the bobbin, to the left above the drum";
    bobbin_mass: 0.7, "kg", "bobbin.mass", "mass";
    spring_stiffness: 2000.0, "N/m", "spring.stiffness", "stiffness of the spring";
    spring_free_length: 0.116, "m", "spring.free_length", "free length of the spring";
}

::machinist_contract::outputs! {
    contact_force: at_once "N", "contact_force", "N, force of the drum on the bobbin at K";
    stop_force: at_once "N", "stop_force", "Q, force of the stop on the post at T";
    strut_push: "N", "strut_push", "force that pushes the ends apart";
    post_angle: "rad", "post_angle", "angle of the bar from the horizontal";
    plate_angle: "rad", "plate_angle", "angle of the bar from the horizontal";
    bobbin_angle: "rad", "bobbin_angle", "angle of the bar from the horizontal";
    drum_angle: "rad", "drum_angle", "angle of the bar from the horizontal";
}

::machinist_contract::states! {
    POST_X: position guess, 0.1, "m", "post.x", "horizontal position of the centre of mass";
    POST_Y: position guess, 0.1, "m", "post.y", "height of the centre of mass";
    POST_PHI: position guess, 1.0, "rad", "post.phi", "angle of the bar from the horizontal";
    PLATE_X: position guess, 0.1, "m", "plate.x", "horizontal position of the centre of mass";
    PLATE_Y: position guess, 0.1, "m", "plate.y", "height of the centre of mass";
    PLATE_PHI: position guess, 1.0, "rad", "plate.phi", "angle of the bar from the horizontal";
    CYLINDER_X: position guess, 0.1, "m", "cylinder.x", "horizontal position of the centre of mass";
    CYLINDER_Y: position guess, 0.1, "m", "cylinder.y", "height of the centre of mass";
    CYLINDER_PHI: position guess, 1.0, "rad", "cylinder.phi", "angle of the bar from the horizontal";
    ROD_X: position guess, 0.1, "m", "rod.x", "horizontal position of the centre of mass";
    ROD_Y: position guess, 0.1, "m", "rod.y", "height of the centre of mass";
    ROD_PHI: position guess, 1.0, "rad", "rod.phi", "angle of the bar from the horizontal";
    BOBBIN_X: position guess, 0.1, "m", "bobbin.x", "horizontal position of the centre of mass";
    BOBBIN_Y: position guess, 0.1, "m", "bobbin.y", "height of the centre of mass";
    BOBBIN_PHI: position guess, 1.0, "rad", "bobbin.phi", "angle of the bar from the horizontal";
    DRUM_X: position guess, 0.1, "m", "drum.x", "horizontal position of the centre of mass";
    DRUM_Y: position guess, 0.1, "m", "drum.y", "height of the centre of mass";
    DRUM_PHI: position guess, 1.0, "rad", "drum.phi", "angle of the bar from the horizontal";
    POST_V_X: velocity guess, 1.0, "m/s", "post.v_x", "rate of horizontal position of the centre of mass";
    POST_V_Y: velocity guess, 1.0, "m/s", "post.v_y", "rate of height of the centre of mass";
    POST_OMEGA: velocity guess, 10.0, "rad/s", "post.omega", "rate of angle of the bar from the horizontal";
    PLATE_V_X: velocity guess, 1.0, "m/s", "plate.v_x", "rate of horizontal position of the centre of mass";
    PLATE_V_Y: velocity guess, 1.0, "m/s", "plate.v_y", "rate of height of the centre of mass";
    PLATE_OMEGA: velocity guess, 10.0, "rad/s", "plate.omega", "rate of angle of the bar from the horizontal";
    CYLINDER_V_X: velocity guess, 1.0, "m/s", "cylinder.v_x", "rate of horizontal position of the centre of mass";
    CYLINDER_V_Y: velocity guess, 1.0, "m/s", "cylinder.v_y", "rate of height of the centre of mass";
    CYLINDER_OMEGA: velocity guess, 10.0, "rad/s", "cylinder.omega", "rate of angle of the bar from the horizontal";
    ROD_V_X: velocity guess, 1.0, "m/s", "rod.v_x", "rate of horizontal position of the centre of mass";
    ROD_V_Y: velocity guess, 1.0, "m/s", "rod.v_y", "rate of height of the centre of mass";
    ROD_OMEGA: velocity guess, 10.0, "rad/s", "rod.omega", "rate of angle of the bar from the horizontal";
    BOBBIN_V_X: velocity guess, 1.0, "m/s", "bobbin.v_x", "rate of horizontal position of the centre of mass";
    BOBBIN_V_Y: velocity guess, 1.0, "m/s", "bobbin.v_y", "rate of height of the centre of mass";
    BOBBIN_OMEGA: velocity, 10.0, "rad/s", "bobbin.omega", "rate of angle of the bar from the horizontal";
    DRUM_V_X: velocity guess, 1.0, "m/s", "drum.v_x", "rate of horizontal position of the centre of mass";
    DRUM_V_Y: velocity guess, 1.0, "m/s", "drum.v_y", "rate of height of the centre of mass";
    DRUM_OMEGA: velocity, 10.0, "rad/s", "drum.omega", "rate of angle of the bar from the horizontal";
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
    "axle_b_x": of_positions, "m", "axle B of the drum in the frame, horizontal";
    "axle_b_y": of_positions, "m", "axle B of the drum in the frame, vertical";
    "contact": of_positions, "m", "K: the bobbin touches the drum";
    "stop": of_positions, "m", "T: the post touches its stop";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 18 by 18 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] 8 [8] 9 [9]
        10 [10] 11 [11] 12 [12] 13 [13] 14 [14] 15 [15] 16 [16] 17 [17] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 36 by 36 { 0 [18] 1 [19] 2 [20] 3 [21] 4 [22] 5 [23] 6 [24] 7 [25]
        8 [26] 9 [27] 10 [28] 11 [29] 12 [30] 13 [31] 14 [32] 15 [33] 16 [34] 17 [35] 18 [2 20]
        19 [2 20] 20 [2 20] 21 [2 5 12 13 15 16 20 23 30 31 33 34]
        22 [2 5 12 13 15 16 20 23 30 31 33 34] 23 [2 5 12 13 15 16 20 23 30 31 33 34]
        24 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        25 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        26 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        27 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        28 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        29 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        30 [2 5 12 13 15 16 20 23 30 31 33 34] 31 [2 5 12 13 15 16 20 23 30 31 33 34] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 36 by 5 {  }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 16 by 18 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6 8]
        5 [4 5 7 8] 6 [8 11] 7 [6 7 8 9 10] 8 [9 11] 9 [10 11] 10 [3 5 12] 11 [4 5 13] 12 [15]
        13 [16] 14 [12 13 15 16] 15 [2] }
}

::machinist_contract::constants! {
    inverse_bobbin_mass
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 1 operation.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    Constants { inverse_bobbin_mass }
}

/// What several functions need of the motion; `motion` says what each is.
#[allow(missing_docs, reason = "`motion` says what each is")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    pub factors: [R; 58],
    pub cos_post_phi: R,
    pub sin_post_phi: R,
    pub cos_plate_phi: R,
    pub sin_plate_phi: R,
    pub cos_cylinder_phi: R,
    pub sin_cylinder_phi: R,
    pub cos_rod_phi: R,
    pub sin_rod_phi: R,
    pub bobbin_x_minus_drum_x_squared: R,
    pub bobbin_y_minus_drum_y_squared: R,
    pub between: R,
    pub slide: R,
    pub t8: R,
    pub t10: R,
    pub t11: R,
    pub t12: R,
    pub t22: R,
    pub t24: R,
    pub t27: R,
    pub t31: R,
    pub t34: R,
    pub t35: R,
    pub t38: R,
    pub t41: R,
    pub t42: R,
    pub t48: R,
    pub t51: R,
    pub t67: R,
    pub t69: R,
    pub t75: R,
    pub t80: R,
    pub t83: R,
    pub t84: R,
    pub t95: R,
    pub t97: R,
    pub t100: R,
    pub t107: R,
    pub t108: R,
    pub t110: R,
    pub t111: R,
    pub t121: R,
    pub t122: R,
    pub post_v_x_dot: R,
    pub t125: R,
    pub t132: R,
    pub bobbin_v_y_dot: R,
    pub bobbin_v_x_dot: R,
    pub plate_omega_dot: R,
    pub t135: R,
    pub t136: R,
    pub t142: R,
    pub t148: R,
    pub rod_omega_dot: R,
    pub t149: R,
    pub rod_v_x_dot: R,
    pub cylinder_omega_dot: R,
    pub cylinder_v_y_dot: R,
    pub t150: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions
/// need. 467 operations.
#[must_use]
pub fn motion<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> Motion<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, _, _, post_omega, _, _, plate_omega,
        cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x,
        bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
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
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let t7 = -t0;
    let t8 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t9 = -t2;
    let t10 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = R::literal(1.0) / t8;
    let t13 = -t12;
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = -t15;
    let t17 = t10 * R::literal(400.0);
    let t18 = -t17;
    let t19 = t11 * R::literal(400.0);
    let t20 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t21 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t22 = R::literal(1.0) / R::literal(0.833_333_333_333_333_4).add_product(t14, t3);
    let t23 = -t22;
    let t24 = t15 * t3;
    let t25 = t24 * t22;
    let t26 = -t25;
    let t27 = t17 * t3;
    let t28 = R::literal(0.833_333_333_333_333_4) + t27;
    let t29 = t28 * t22;
    let t30 = -t29;
    let t31 = t19 * t3;
    let t32 = t31 * t22;
    let t33 = R::literal(1.0) / (-R::literal(0.833_333_333_333_333_4).add_product(t15, t2))
        .add_product(t25, t24);
    let t34 = t17 * t2;
    let t35 = t29 * t24;
    let t36 = t35 - t34;
    let t37 = t36 * t33;
    let t38 = R::literal(0.833_333_333_333_333_4).add_product(t19, t2).sub_product(t32, t24);
    let t39 = t38 * t33;
    let t40 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + c.inverse_bobbin_mass)).add_product(t29, t28).sub_product(t37, t36);
    let t41 = (t19 * t10).sub_product(t32, t28);
    let t42 = t39 * t36;
    let t43 = t41 - t42;
    let t44 = t43 * t40;
    let t45 = t20 * t40;
    let t46 = -t45;
    let t47 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t19, t11)
        + c.inverse_bobbin_mass)).add_product(t32, t31).sub_product(t39, t38).sub_product(t44, t43);
    let t48 = t45 * t43;
    let t49 = t48 - t21;
    let t50 = t49 * t47;
    let t51 = R::literal(1.0) / (t20 * bobbin_x_minus_drum_x_over_between).add_product(t21,
        bobbin_y_minus_drum_y_over_between).add_product(t45, t20).add_product(t50, t49);
    let t52 = -t51;
    let t53 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t54 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t55 = -t54;
    let t56 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t57 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t58 = -t57;
    let t59 = slide * R::literal(2_777.777_777_777_778);
    let t60 = -t59;
    let t61 = sin_cylinder_phi * R::literal(5.0);
    let t62 = -t61;
    let t63 = cos_cylinder_phi * R::literal(5.0);
    let t64 = R::literal(250.0) * sin_rod_phi;
    let t65 = -t64;
    let t66 = R::literal(250.0) * cos_rod_phi;
    let t67 = R::literal(1.0) / R::literal(3.333_333_333_333_333_5).add_product(t56, t5);
    let t68 = -t67;
    let t69 = t57 * t5;
    let t70 = t69 * t67;
    let t71 = -t70;
    let t72 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t73 = t72 * t67;
    let t74 = (-t53).add_product(t59, t5);
    let t75 = t74 * t67;
    let t76 = -t75;
    let t77 = R::literal(1.0) / (-R::literal(3.333_333_333_333_333_5).add_product(t57, t4))
        .add_product(t70, t69);
    let t78 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t73, t69);
    let t79 = t78 * t77;
    let t80 = t54.sub_product(t59, t4).add_product(t75, t69);
    let t81 = t80 * t77;
    let t82 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t73, t72)
        .sub_product(t79, t78);
    let t83 = t59.add_product(t75, t72);
    let t84 = t81 * t78;
    let t85 = t83 + t84;
    let t86 = t85 * t82;
    let t87 = -t86;
    let t88 = t64 * t82;
    let t89 = t66 * t82;
    let t90 = -t89;
    let t91 = R::literal(1.0) / (-(t53 * sin_cylinder_phi).add_product(t54, cos_cylinder_phi)
        .add_product(t59, slide).add_product(t61, sin_cylinder_phi).add_product(t63,
        cos_cylinder_phi)).add_product(t75, t74).sub_product(t81, t80).sub_product(t86, t85);
    let t92 = t61.add_product(t88, t85);
    let t93 = t92 * t91;
    let t94 = t63.add_product(t89, t85);
    let t95 = t94 * t91;
    let t96 = -t95;
    let t97 = R::literal(1.0) / R::literal(5.0).add_product(t64, t6).add_product(t88, t64)
        .add_product(t93, t92);
    let t98 = -t97;
    let t99 = (t66 * t6).add_product(t89, t64).add_product(t95, t92);
    let t100 = t99 * t97;
    let t101 = -t100;
    let t102 = R::literal(1.0) / (-R::literal(5.0).add_product(t66, R::literal(0.06) * cos_rod_phi)
        .add_product(t89, t66).add_product(t95, t94)).add_product(t100, t99);
    let post_omega_squared = post_omega * post_omega;
    let t103 = R::literal(0.1) * post_omega_squared;
    let t104 = t103 * cos_post_phi;
    let t105 = t103 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t106 = R::literal(0.06) * plate_omega_squared;
    let t107 = t106 * cos_plate_phi;
    let t108 = t106 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t109 = R::literal(0.06) * (rod_omega * rod_omega);
    let t110 = t109 * cos_rod_phi;
    let t111 = t109 * sin_rod_phi;
    let between_squared_times_between = between * between * between;
    let t112 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t113 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t114 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t115 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t116 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t117 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t118 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t119 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t120 = (bobbin_v_x * (bobbin_v_x_over_between + t114 + t115 - t112 - t113
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t118 + t119
        - t116 - t117 - drum_v_y_over_between).add_product(drum_v_x, t112 + t113
        + drum_v_x_over_between - bobbin_v_x_over_between - t114 - t115).add_product(drum_v_y, t116
        + t117 + drum_v_y_over_between - bobbin_v_y_over_between - t118 - t119);
    let t121 = (R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi);
    let t122 = t12 * (t121 * post_omega_squared);
    let t123 = t1 * t122;
    let post_v_x_dot = t123 - t104;
    let t124 = t0 * t122;
    let t125 = t105 + t124;
    let t126 = t123 - (t107 + t104) - (t104 - t123);
    let t127 = (-(t108 + t105 + t124 + t125)).add_product(t25, t126);
    let t128 = (t11 * plate_omega_squared).add_product(t29, t126).sub_product(t37, t127);
    let t129 = (t10 * plate_omega_squared).sub_product(t32, t126).sub_product(t39, t127)
        .sub_product(t44, t128);
    let t130 = (-t120).add_product(t45, t128).sub_product(t50, t129) * t51;
    let t131 = (t129 * t47).add_product(t50, t130);
    let t132 = (t128 * t40).sub_product(t44, t131).sub_product(t45, t130);
    let t133 = (t127 * t33).sub_product(t37, t132).sub_product(t39, t131);
    let t134 = (-(t126 * t22)).add_product(t25, t133).add_product(t29, t132).sub_product(t32, t131);
    let bobbin_v_y_dot = (t21 * t130).sub_product(c.inverse_bobbin_mass, t131);
    let bobbin_v_x_dot = (t20 * t130).sub_product(c.inverse_bobbin_mass, t132);
    let plate_omega_dot = (t15 * t133).sub_product(t14, t134).add_product(t17, t132)
        .sub_product(t19, t131);
    let t135 = (R::literal(-0.833_333_333_333_333_4) * t131)
        .add_product(R::literal(0.833_333_333_333_333_4), t133);
    let t136 = R::literal(0.833_333_333_333_333_4) * t134;
    let t137 = t136.add_product(R::literal(-0.833_333_333_333_333_4), t132)
        .add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)).add_product(t3, plate_omega_dot);
    let t138 = (-t135.add_product(R::literal(0.06), (plate_omega_squared * sin_plate_phi)
        .add_product(cylinder_omega_squared, sin_cylinder_phi))).add_product(t2, plate_omega_dot)
        .sub_product(t70, t137);
    let t139 = (t73 * t137).sub_product(t79, t138);
    let t140 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t75, t137)
        .sub_product(t81, t138).add_product(t86, t139);
    let t141 = t110.sub_product(t88, t139).sub_product(t93, t140);
    let t142 = t111.add_product(t89, t139).add_product(t95, t140).add_product(t100, t141) * t102;
    let t143 = (-(t141 * t97)).add_product(t100, t142);
    let t144 = (t140 * t91).sub_product(t93, t143).add_product(t95, t142);
    let t145 = (t139 * t82).add_product(t86, t144).sub_product(t88, t143).add_product(t89, t142);
    let t146 = (t138 * t77).sub_product(t79, t145).sub_product(t81, t144);
    let t147 = (t137 * t67).add_product(t70, t146).sub_product(t73, t145).add_product(t75, t144);
    let t148 = (t64 * t143).sub_product(R::literal(4_166.666_666_666_667), t145);
    let rod_omega_dot = t148.sub_product(t66, t142);
    let t149 = t63 * t144;
    let rod_v_x_dot = (R::literal(-5.0) * t143).add_product(t61, t144);
    let cylinder_omega_dot = (t57 * t146).sub_product(t56, t147)
        .sub_product(R::literal(-2_777.777_777_777_778), t145).add_product(t59, t144);
    let cylinder_v_y_dot = (t54 * t144).sub_product(R::literal(3.333_333_333_333_333_5), t146);
    let t150 = (t53 * t144).add_product(R::literal(3.333_333_333_333_333_5), t147);
    Motion {
        factors: [t13, t1, R::literal(-1.0), t7, t26, t30, t37, t32, t39, t44, t46, t50, t52, t47,
            t40, t33, t23, c.inverse_bobbin_mass, t21, t20, t14, t16, t18, t19,
            R::literal(0.833_333_333_333_333_4), R::literal(-0.833_333_333_333_333_4), t3, t9, t71,
            t73, t79, t76, t81, t87, t88, t93, t90, t96, t101, t102, t98, t91, t82, t77, t68,
            R::literal(4_166.666_666_666_667), t65, t66, t63, R::literal(5.0), t62, t56, t58,
            R::literal(-2_777.777_777_777_778), t60, R::literal(3.333_333_333_333_333_5), t55, t53],
        cos_post_phi,
        sin_post_phi,
        cos_plate_phi,
        sin_plate_phi,
        cos_cylinder_phi,
        sin_cylinder_phi,
        cos_rod_phi,
        sin_rod_phi,
        bobbin_x_minus_drum_x_squared,
        bobbin_y_minus_drum_y_squared,
        between,
        slide,
        t8,
        t10,
        t11,
        t12,
        t22,
        t24,
        t27,
        t31,
        t34,
        t35,
        t38,
        t41,
        t42,
        t48,
        t51,
        t67,
        t69,
        t75,
        t80,
        t83,
        t84,
        t95,
        t97,
        t100,
        t107,
        t108,
        t110,
        t111,
        t121,
        t122,
        post_v_x_dot,
        t125,
        t132,
        bobbin_v_y_dot,
        bobbin_v_x_dot,
        plate_omega_dot,
        t135,
        t136,
        t142,
        t148,
        rod_omega_dot,
        t149,
        rod_v_x_dot,
        cylinder_omega_dot,
        cylinder_v_y_dot,
        t150,
    }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.096), R::literal(0.03), R::literal(0.3), R::literal(0.172), R::literal(0.116),
        R::literal(1.9), R::literal(0.103), R::literal(0.207), R::literal(2.53), R::literal(0.049),
        R::literal(0.245), R::literal(2.53), R::literal(0.269), R::literal(0.139), R::literal(0.0),
        R::literal(0.328), R::literal(0.058), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(-20.0), R::literal(0.0), R::literal(0.0),
        R::literal(30.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 449 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y, post_omega,
        plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega, drum_v_x, drum_v_y, drum_omega]
        = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.06) * cos_plate_phi;
    let t1 = R::literal(0.06) * sin_plate_phi;
    let t2 = R::literal(0.06) * cos_cylinder_phi;
    let t3 = R::literal(0.06) * sin_cylinder_phi;
    let t4 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let t5 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t6 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t7 = R::literal(24.0) * sin_plate_phi;
    let t8 = R::literal(24.0) * cos_plate_phi;
    let t9 = t5 * R::literal(400.0);
    let t10 = t6 * R::literal(400.0);
    let t11 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t12 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t13 = R::literal(1.0) / R::literal(0.833_333_333_333_333_4).add_product(t7, t1);
    let t14 = t8 * t1;
    let t15 = t14 * t13;
    let t16 = R::literal(0.833_333_333_333_333_4).add_product(t9, t1);
    let t17 = t16 * t13;
    let t18 = t10 * t1;
    let t19 = t18 * t13;
    let t20 = R::literal(1.0) / (-R::literal(0.833_333_333_333_333_4).add_product(t8, t0))
        .add_product(t15, t14);
    let t21 = (-(t9 * t0)).add_product(t17, t14);
    let t22 = t21 * t20;
    let t23 = R::literal(0.833_333_333_333_333_4).add_product(t10, t0).sub_product(t19, t14);
    let t24 = t23 * t20;
    let t25 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t9, t5)
        + c.inverse_bobbin_mass)).add_product(t17, t16).sub_product(t22, t21);
    let t26 = (t10 * t5).sub_product(t19, t16).sub_product(t24, t21);
    let t27 = t26 * t25;
    let t28 = t11 * t25;
    let t29 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t10, t6)
        + c.inverse_bobbin_mass)).add_product(t19, t18).sub_product(t24, t23).sub_product(t27, t26);
    let t30 = (-t12).add_product(t28, t26);
    let t31 = t30 * t29;
    let t32 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t33 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t34 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t35 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t36 = slide * R::literal(2_777.777_777_777_778);
    let t37 = sin_cylinder_phi * R::literal(5.0);
    let t38 = cos_cylinder_phi * R::literal(5.0);
    let t39 = R::literal(250.0) * sin_rod_phi;
    let t40 = R::literal(250.0) * cos_rod_phi;
    let t41 = R::literal(1.0) / R::literal(3.333_333_333_333_333_5).add_product(t34, t3);
    let t42 = t35 * t3;
    let t43 = t42 * t41;
    let t44 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t45 = t44 * t41;
    let t46 = (-t32).add_product(t36, t3);
    let t47 = t46 * t41;
    let t48 = R::literal(1.0) / (-R::literal(3.333_333_333_333_333_5).add_product(t35, t2))
        .add_product(t43, t42);
    let t49 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t45, t42);
    let t50 = t49 * t48;
    let t51 = t33.sub_product(t36, t2).add_product(t47, t42);
    let t52 = t51 * t48;
    let t53 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t45, t44)
        .sub_product(t50, t49);
    let t54 = t36.add_product(t47, t44).add_product(t52, t49);
    let t55 = t54 * t53;
    let t56 = t39 * t53;
    let t57 = t40 * t53;
    let t58 = R::literal(1.0) / (-(t32 * sin_cylinder_phi).add_product(t33, cos_cylinder_phi)
        .add_product(t36, slide).add_product(t37, sin_cylinder_phi).add_product(t38,
        cos_cylinder_phi)).add_product(t47, t46).sub_product(t52, t51).sub_product(t55, t54);
    let t59 = t37.add_product(t56, t54);
    let t60 = t59 * t58;
    let t61 = t38.add_product(t57, t54);
    let t62 = t61 * t58;
    let t63 = R::literal(1.0) / R::literal(5.0).add_product(t39, t4).add_product(t56, t39)
        .add_product(t60, t59);
    let t64 = (t40 * t4).add_product(t57, t39).add_product(t62, t59);
    let t65 = t64 * t63;
    let post_omega_squared = post_omega * post_omega;
    let t66 = R::literal(0.1) * post_omega_squared;
    let t67 = t66 * cos_post_phi;
    let t68 = t66 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t69 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t70 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t71 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t72 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t73 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t74 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t75 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t76 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t77 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t78 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t79 = (bobbin_v_x * (bobbin_v_x_over_between + t73 + t74 - t71 - t72
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t77 + t78 - t75
        - t76 - drum_v_y_over_between).add_product(drum_v_x, t71 + t72 + drum_v_x_over_between
        - bobbin_v_x_over_between - t73 - t74).add_product(drum_v_y, t75 + t76
        + drum_v_y_over_between - bobbin_v_y_over_between - t77 - t78);
    let t80 = R::literal(1.0) / (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143),
        cos_post_phi) * ((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143),
        sin_post_phi) * post_omega_squared);
    let post_omega_dot = -t80;
    let t81 = R::literal(0.1) * sin_post_phi * t80;
    let post_v_x_dot = t81 - t67;
    let t82 = R::literal(0.1) * cos_post_phi * t80;
    let t83 = t68 + t82;
    let post_v_y_dot = -t83;
    let t84 = t81 - t67.add_product(t69, cos_plate_phi) - (t67 - t81);
    let t85 = (-(t68.add_product(t69, sin_plate_phi) + t82 + t83)).add_product(t15, t84);
    let t86 = (t6 * plate_omega_squared).add_product(t17, t84).sub_product(t22, t85);
    let t87 = (t5 * plate_omega_squared).sub_product(t19, t84).sub_product(t24, t85)
        .sub_product(t27, t86);
    let t88 = (-t79).add_product(t28, t86).sub_product(t31, t87) * (R::literal(1.0)
        / (t11 * bobbin_x_minus_drum_x_over_between).add_product(t12,
        bobbin_y_minus_drum_y_over_between).add_product(t28, t11).add_product(t31, t30));
    let t89 = (t87 * t29).add_product(t31, t88);
    let t90 = (t86 * t25).sub_product(t27, t89).sub_product(t28, t88);
    let t91 = (t85 * t20).sub_product(t22, t90).sub_product(t24, t89);
    let t92 = (-(t84 * t13)).add_product(t15, t91).add_product(t17, t90).sub_product(t19, t89);
    let bobbin_v_y_dot = (t12 * t88).sub_product(c.inverse_bobbin_mass, t89);
    let bobbin_v_x_dot = (t11 * t88).sub_product(c.inverse_bobbin_mass, t90);
    let plate_omega_dot = (t8 * t91).sub_product(t7, t92).add_product(t9, t90).sub_product(t10,
        t89);
    let t93 = (R::literal(-0.833_333_333_333_333_4) * t89)
        .add_product(R::literal(0.833_333_333_333_333_4), t91);
    let plate_v_y_dot = -t93;
    let t94 = (R::literal(-0.833_333_333_333_333_4) * t90)
        .add_product(R::literal(0.833_333_333_333_333_4), t92);
    let plate_v_x_dot = -t94;
    let t95 = t94.add_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)).add_product(t1, plate_omega_dot);
    let t96 = (-t93.add_product(R::literal(0.06), (plate_omega_squared * sin_plate_phi)
        .add_product(cylinder_omega_squared, sin_cylinder_phi))).add_product(t0, plate_omega_dot)
        .sub_product(t43, t95);
    let t97 = (t45 * t95).sub_product(t50, t96);
    let t98 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t47, t95)
        .sub_product(t52, t96).add_product(t55, t97);
    let t99 = (t70 * cos_rod_phi).sub_product(t56, t97).sub_product(t60, t98);
    let t100 = (t70 * sin_rod_phi).add_product(t57, t97).add_product(t62, t98).add_product(t65,
        t99) * (R::literal(1.0) / (-R::literal(5.0).add_product(t40, R::literal(0.06) * cos_rod_phi)
        .add_product(t57, t40).add_product(t62, t61)).add_product(t65, t64));
    let t101 = (-(t99 * t63)).add_product(t65, t100);
    let t102 = (t98 * t58).sub_product(t60, t101).add_product(t62, t100);
    let t103 = (t97 * t53).add_product(t55, t102).sub_product(t56, t101).add_product(t57, t100);
    let t104 = (t96 * t48).sub_product(t50, t103).sub_product(t52, t102);
    let t105 = (t95 * t41).add_product(t43, t104).sub_product(t45, t103).add_product(t47, t102);
    let rod_omega_dot = (t39 * t101).sub_product(R::literal(4_166.666_666_666_667), t103)
        .sub_product(t40, t100);
    let rod_v_y_dot = (R::literal(-5.0) * t100).sub_product(t38, t102);
    let rod_v_x_dot = (R::literal(-5.0) * t101).add_product(t37, t102);
    let cylinder_omega_dot = (t35 * t104).sub_product(t34, t105)
        .sub_product(R::literal(-2_777.777_777_777_778), t103).add_product(t36, t102);
    let cylinder_v_y_dot = (t33 * t102).sub_product(R::literal(3.333_333_333_333_333_5), t104);
    let cylinder_v_x_dot = (-(t32 * t102)).add_product(R::literal(-3.333_333_333_333_333_5), t105);
    [post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
        cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega,
        drum_v_x, drum_v_y, drum_omega, post_v_x_dot, post_v_y_dot, post_omega_dot, plate_v_x_dot,
        plate_v_y_dot, plate_omega_dot, cylinder_v_x_dot, cylinder_v_y_dot, cylinder_omega_dot,
        rod_v_x_dot, rod_v_y_dot, rod_omega_dot, bobbin_v_x_dot, bobbin_v_y_dot, R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 18] {
    [R::literal(0.8), R::literal(0.8), R::literal(0.0027), R::literal(1.2), R::literal(1.2),
        R::literal(0.0025), R::literal(0.3), R::literal(0.3), R::literal(0.00036), R::literal(0.2),
        R::literal(0.2), R::literal(0.00024), p.bobbin_mass, p.bobbin_mass, R::literal(0.0013),
        R::literal(1.5), R::literal(1.5), R::literal(0.0012)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 49 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _, bobbin_x,
        bobbin_y, _, drum_x, drum_y, _, _, _, _, _, _, _, cylinder_v_x, cylinder_v_y,
        cylinder_omega, rod_v_x, rod_v_y, ..] = *state;
    let (sin_cylinder_phi, cos_cylinder_phi) = cylinder_phi.sin_cos();
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t0 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t0)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let plate_phi_forcing = -(p.bobbin_radius * p.winding_force);
    let t1 = R::literal(50.0) * slide_rate;
    let t2 = p.spring_stiffness * (slide - p.spring_free_length);
    let cylinder_x_forcing = (t2 * cos_cylinder_phi).add_product(t1, cos_cylinder_phi);
    let t3 = t2 * sin_cylinder_phi;
    let t4 = t1 * sin_cylinder_phi;
    let cylinder_y_forcing = t4 - (R::literal(2.943) - t3);
    let cylinder_phi_forcing = -(t2 * t0).add_product(t1, t0);
    let rod_x_forcing = -cylinder_x_forcing;
    let rod_y_forcing = R::literal(-1.962) - t3 - t4;
    let bobbin_x_forcing = -(p.winding_force * bobbin_y_minus_drum_y / between);
    let bobbin_y_forcing = (p.winding_force * bobbin_x_minus_drum_x / between)
        .sub_product(R::literal(9.81), p.bobbin_mass);
    [R::literal(0.0), R::literal(-7.848), R::literal(0.0), R::literal(0.0), R::literal(-11.772),
        plate_phi_forcing, cylinder_x_forcing, cylinder_y_forcing, cylinder_phi_forcing,
        rod_x_forcing, rod_y_forcing, R::literal(0.0), bobbin_x_forcing, bobbin_y_forcing,
        R::literal(0.0), R::literal(0.0), R::literal(-14.715), R::literal(0.0)]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 415 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 228] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x, bobbin_y, _,
        drum_x, drum_y, _, _, _, post_omega, _, _, plate_omega, cylinder_v_x, cylinder_v_y,
        cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y,
        ..] = *state;
    let m = &motion(time, state, p, c);
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t0 = cylinder_omega_squared * m.sin_cylinder_phi;
    let t1 = R::literal(2.0) * cylinder_v_x;
    let t2 = R::literal(2.0) * cylinder_v_y;
    let t3 = R::literal(2.0) * rod_v_x;
    let t4 = R::literal(2.0) * rod_v_y;
    let t5 = m.between * m.between;
    let t6 = t5 * m.between;
    let t7 = m.t108.sub_product(R::literal(0.06) * m.cos_plate_phi, m.plate_omega_dot);
    let t8 = -m.t107.add_product(m.factors[26], m.plate_omega_dot);
    let t9 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t10 = (m.sin_cylinder_phi * m.cylinder_omega_dot).add_product(cylinder_omega_squared,
        m.cos_cylinder_phi);
    let t11 = R::literal(0.06) * cylinder_omega_squared;
    let t12 = R::literal(3.0) * bobbin_v_x;
    let t13 = t12 * bobbin_x_minus_drum_x;
    let t14 = t13 / t6;
    let t15 = m.between.powi(5);
    let t16 = m.bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t17 = R::literal(3.0) * drum_v_x;
    let t18 = t17 * t16 / t15;
    let t19 = R::literal(3.0) * drum_v_y;
    let t20 = t19 * bobbin_y_minus_drum_y;
    let t21 = t20 * m.bobbin_x_minus_drum_x_squared / t15;
    let t22 = bobbin_v_y * bobbin_y_minus_drum_y / t6;
    let t23 = t12 * t16 / t15;
    let t24 = R::literal(3.0) * bobbin_v_y;
    let t25 = t24 * bobbin_y_minus_drum_y;
    let t26 = t25 * m.bobbin_x_minus_drum_x_squared / t15;
    let t27 = t17 * bobbin_x_minus_drum_x;
    let t28 = t27 / t6;
    let t29 = drum_v_y * bobbin_y_minus_drum_y / t6;
    let t30 = t23 + t26 + t28 + t29 - t14 - t18 - t21 - t22;
    let t31 = t17 * bobbin_y_minus_drum_y * m.bobbin_x_minus_drum_x_squared / t15;
    let t32 = t19 * bobbin_x_minus_drum_x * m.bobbin_y_minus_drum_y_squared / t15;
    let t33 = bobbin_v_x * bobbin_y_minus_drum_y / t6;
    let t34 = bobbin_v_y * bobbin_x_minus_drum_x / t6;
    let t35 = t12 * bobbin_y_minus_drum_y * m.bobbin_x_minus_drum_x_squared / t15;
    let t36 = t24 * bobbin_x_minus_drum_x * m.bobbin_y_minus_drum_y_squared / t15;
    let t37 = drum_v_x * bobbin_y_minus_drum_y / t6;
    let t38 = drum_v_y * bobbin_x_minus_drum_x / t6;
    let t39 = t35 + t36 + t37 + t38 - t31 - t32 - t33 - t34;
    let t40 = t14 + t18 + t21 + t22 - t23 - t26 - t28 - t29;
    let t41 = t31 + t32 + t33 + t34 - t35 - t36 - t37 - t38;
    let t42 = m.bobbin_x_minus_drum_x_squared / t6;
    let t43 = R::literal(1.0) / m.between;
    let t44 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y / t6;
    let t45 = t44 * m.bobbin_v_y_dot;
    let t46 = t25 / t6;
    let t47 = t27 * m.bobbin_y_minus_drum_y_squared / t15;
    let t48 = m.bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t49 = t19 * t48 / t15;
    let t50 = bobbin_v_x * bobbin_x_minus_drum_x / t6;
    let t51 = t13 * m.bobbin_y_minus_drum_y_squared / t15;
    let t52 = t24 * t48 / t15;
    let t53 = t20 / t6;
    let t54 = drum_v_x * bobbin_x_minus_drum_x / t6;
    let t55 = t51 + t52 + t53 + t54 - t46 - t47 - t49 - t50;
    let t56 = t46 + t47 + t49 + t50 - t51 - t52 - t53 - t54;
    let t57 = t44 * m.bobbin_v_x_dot;
    let t58 = m.bobbin_y_minus_drum_y_squared / t6;
    let t59 = R::literal(0.2) * post_omega;
    let t60 = -(t59 * m.cos_post_phi);
    let t61 = -(t59 * m.sin_post_phi);
    let t62 = R::literal(0.12) * plate_omega;
    let t63 = -(t62 * m.cos_plate_phi);
    let t64 = -(t62 * m.sin_plate_phi);
    let t65 = R::literal(2.0) * cylinder_omega;
    let t66 = t65 * m.cos_cylinder_phi;
    let t67 = t65 * m.sin_cylinder_phi;
    let t68 = R::literal(0.12) * cylinder_omega;
    let t69 = R::literal(0.12) * rod_omega;
    let t70 = R::literal(4.0) * bobbin_x * drum_x;
    let t71 = t70 * bobbin_v_x;
    let t72 = R::literal(2.0) * bobbin_x;
    let t73 = t72 * bobbin_y;
    let t74 = t73 * drum_v_y;
    let t75 = t72 * drum_y;
    let t76 = t75 * bobbin_v_y;
    let t77 = R::literal(2.0) * bobbin_y * drum_x;
    let t78 = t77 * bobbin_v_y;
    let t79 = R::literal(2.0) * drum_x * drum_y;
    let t80 = t79 * drum_v_y;
    let t81 = R::literal(2.0) * bobbin_v_x;
    let t82 = t81 * t5;
    let bobbin_x_squared = bobbin_x * bobbin_x;
    let t83 = R::literal(2.0) * drum_v_x;
    let t84 = t83 * bobbin_x_squared;
    let drum_x_squared = drum_x * drum_x;
    let t85 = t83 * drum_x_squared;
    let t86 = t73 * bobbin_v_y;
    let t87 = t75 * drum_v_y;
    let t88 = t77 * drum_v_y;
    let t89 = t79 * bobbin_v_y;
    let t90 = t81 * bobbin_x_squared;
    let t91 = t81 * drum_x_squared;
    let t92 = t83 * t5;
    let t93 = t70 * drum_v_x;
    let t94 = R::literal(4.0) * bobbin_y * drum_y;
    let t95 = t94 * bobbin_v_y;
    let t96 = t73 * drum_v_x;
    let t97 = t75 * bobbin_v_x;
    let t98 = t77 * bobbin_v_x;
    let t99 = t79 * drum_v_x;
    let t100 = R::literal(2.0) * bobbin_v_y;
    let t101 = t100 * t5;
    let bobbin_y_squared = bobbin_y * bobbin_y;
    let t102 = R::literal(2.0) * drum_v_y;
    let t103 = t102 * bobbin_y_squared;
    let drum_y_squared = drum_y * drum_y;
    let t104 = t102 * drum_y_squared;
    let t105 = t73 * bobbin_v_x;
    let t106 = t75 * drum_v_x;
    let t107 = t77 * drum_v_x;
    let t108 = t79 * bobbin_v_x;
    let t109 = t100 * bobbin_y_squared;
    let t110 = t100 * drum_y_squared;
    let t111 = t102 * t5;
    let t112 = t94 * drum_v_y;
    let mut x = [[R::literal(0.0); 24]; 34];
    x[18][0] = m.t125;
    x[19][0] = m.post_v_x_dot;
    x[20][0] = m.t125;
    x[21][0] = m.post_v_x_dot;
    x[33][0] = (m.t121 * m.t122).add_product(m.t8, post_omega * post_omega);
    x[20][1] = t7;
    x[21][1] = t8;
    x[22][1] = t7;
    x[23][1] = t8;
    x[28][1] = (-(m.t10 * plate_omega_squared)).add_product((R::literal(0.01) * m.cos_plate_phi)
        .sub_product(R::literal(0.1), m.sin_plate_phi), m.plate_omega_dot);
    x[29][1] = (m.t10 * m.plate_omega_dot).add_product(m.t11, plate_omega_squared);
    x[25][2] = t0 - t9;
    x[25][3] = -t10;
    x[22][4] = (R::literal(-0.06) * m.cos_cylinder_phi * m.cylinder_omega_dot).add_product(t11,
        m.sin_cylinder_phi);
    x[23][4] = -(R::literal(0.06) * m.sin_cylinder_phi * m.cylinder_omega_dot).add_product(t11,
        m.cos_cylinder_phi);
    x[25][4] = (m.cos_cylinder_phi * m.t150).add_product(cylinder_omega, (t1 * m.sin_cylinder_phi)
        .add_product(t4, m.cos_cylinder_phi).add_product(cylinder_x * cylinder_omega,
        m.cos_cylinder_phi).add_product(cylinder_y * cylinder_omega, m.sin_cylinder_phi)
        .sub_product(t2, m.cos_cylinder_phi).sub_product(t3, m.sin_cylinder_phi).sub_product(rod_x
        * cylinder_omega, m.cos_cylinder_phi).sub_product(rod_y * cylinder_omega,
        m.sin_cylinder_phi)).sub_product(m.sin_cylinder_phi, m.cylinder_v_y_dot)
        .sub_product(((rod_x - cylinder_x) * m.sin_cylinder_phi).sub_product(rod_y - cylinder_y,
        m.cos_cylinder_phi), m.cylinder_omega_dot).add_product(m.cos_cylinder_phi, m.rod_v_x_dot)
        .sub_product(m.sin_cylinder_phi, m.t149.add_product(R::literal(5.0), m.t142));
    x[25][5] = t9 - t0;
    x[25][6] = t10;
    x[26][7] = (-m.t111).add_product(R::literal(0.06) * m.cos_rod_phi, m.rod_omega_dot);
    x[27][7] = m.t110.add_product(R::literal(0.06) * m.sin_rod_phi, m.rod_omega_dot);
    x[32][8] = t45 - (bobbin_v_x * t30).add_product(bobbin_v_y, t39).add_product(drum_v_x, t40)
        .add_product(drum_v_y, t41).add_product(t43 - t42, m.bobbin_v_x_dot);
    x[32][9] = (t57 - (bobbin_v_x * t39).add_product(bobbin_v_y, t55).add_product(drum_v_x, t41)
        .add_product(drum_v_y, t56)).sub_product(t43 - t58, m.bobbin_v_y_dot);
    x[32][10] = (-(bobbin_v_x * t40).add_product(bobbin_v_y, t41).add_product(drum_v_x, t30)
        .add_product(drum_v_y, t39)).add_product(t43 - t42, m.bobbin_v_x_dot) - t45;
    x[32][11] = (-((bobbin_v_x * t41).add_product(bobbin_v_y, t56).add_product(drum_v_x, t39)
        .add_product(drum_v_y, t55) + t57)).add_product(t43 - t58, m.bobbin_v_y_dot);
    x[18][12] = t60;
    x[19][12] = t61;
    x[20][12] = t60;
    x[21][12] = t61;
    x[33][12] = post_omega * (R::literal(0.286) * m.sin_post_phi).sub_product(R::literal(0.088),
        m.cos_post_phi);
    x[20][13] = t63;
    x[21][13] = t64;
    x[22][13] = t63;
    x[23][13] = t64;
    x[28][13] = plate_omega * (R::literal(0.02) * m.cos_plate_phi).sub_product(R::literal(0.2),
        m.sin_plate_phi);
    x[29][13] = plate_omega * (R::literal(0.02) * m.sin_plate_phi).add_product(R::literal(0.2),
        m.cos_plate_phi);
    x[25][14] = -t66;
    x[25][15] = -t67;
    x[22][16] = -(t68 * m.cos_cylinder_phi);
    x[23][16] = -(t68 * m.sin_cylinder_phi);
    x[25][16] = (R::literal(2.0) * cylinder_x * cylinder_omega * m.sin_cylinder_phi)
        .add_product(R::literal(2.0) * rod_y * cylinder_omega, m.cos_cylinder_phi).add_product(t3,
        m.cos_cylinder_phi).add_product(t4, m.sin_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_y * cylinder_omega, m.cos_cylinder_phi).sub_product(R::literal(2.0) * rod_x
        * cylinder_omega, m.sin_cylinder_phi).sub_product(t1, m.cos_cylinder_phi).sub_product(t2,
        m.sin_cylinder_phi);
    x[25][17] = t66;
    x[25][18] = t67;
    x[26][19] = t69 * m.cos_rod_phi;
    x[27][19] = t69 * m.sin_rod_phi;
    x[32][20] = (t86 + t87 + t88 + t89 + t90 + t91 + t92 + t93 - t71 - t74 - t76 - t78 - t80 - t82
        - t84 - t85) / t6;
    x[32][21] = (t105 + t106 + t107 + t108 + t109 + t110 + t111 + t112 - t95 - t96 - t97 - t98
        - t99 - t101 - t103 - t104) / t6;
    x[32][22] = (t74 + t76 + t78 + t80 + t82 + t84 + t85 + t71 - t93 - t86 - t87 - t88 - t89 - t90
        - t91 - t92) / t6;
    x[32][23] = (t96 + t97 + t98 + t99 + t101 + t103 + t104 + t95 - t112 - t105 - t106 - t107
        - t108 - t109 - t110 - t111) / t6;
    substitute(RATE_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), x[0][0], x[0][12], x[1][0], x[1][12],
        x[2][0], x[2][12], x[3][0], x[3][1], x[3][8], x[3][9], x[3][10], x[3][11], x[3][12],
        x[3][13], x[3][20], x[3][21], x[3][22], x[3][23], x[4][0], x[4][1], x[4][8], x[4][9],
        x[4][10], x[4][11], x[4][12], x[4][13], x[4][20], x[4][21], x[4][22], x[4][23], x[5][0],
        x[5][1], x[5][8], x[5][9], x[5][10], x[5][11], x[5][12], x[5][13], x[5][20], x[5][21],
        x[5][22], x[5][23], x[6][0], x[6][1], x[6][2], x[6][3], x[6][4], x[6][5], x[6][6], x[6][7],
        x[6][8], x[6][9], x[6][10], x[6][11], x[6][12], x[6][13], x[6][14], x[6][15], x[6][16],
        x[6][17], x[6][18], x[6][19], x[6][20], x[6][21], x[6][22], x[6][23], x[7][0], x[7][1],
        x[7][2], x[7][3], x[7][4], x[7][5], x[7][6], x[7][7], x[7][8], x[7][9], x[7][10], x[7][11],
        x[7][12], x[7][13], x[7][14], x[7][15], x[7][16], x[7][17], x[7][18], x[7][19], x[7][20],
        x[7][21], x[7][22], x[7][23], x[8][0], x[8][1], x[8][2], x[8][3], x[8][4], x[8][5],
        x[8][6], x[8][7], x[8][8], x[8][9], x[8][10], x[8][11], x[8][12], x[8][13], x[8][14],
        x[8][15], x[8][16], x[8][17], x[8][18], x[8][19], x[8][20], x[8][21], x[8][22], x[8][23],
        x[9][0], x[9][1], x[9][2], x[9][3], x[9][4], x[9][5], x[9][6], x[9][7], x[9][8], x[9][9],
        x[9][10], x[9][11], x[9][12], x[9][13], x[9][14], x[9][15], x[9][16], x[9][17], x[9][18],
        x[9][19], x[9][20], x[9][21], x[9][22], x[9][23], x[10][0], x[10][1], x[10][2], x[10][3],
        x[10][4], x[10][5], x[10][6], x[10][7], x[10][8], x[10][9], x[10][10], x[10][11],
        x[10][12], x[10][13], x[10][14], x[10][15], x[10][16], x[10][17], x[10][18], x[10][19],
        x[10][20], x[10][21], x[10][22], x[10][23], x[11][0], x[11][1], x[11][2], x[11][3],
        x[11][4], x[11][5], x[11][6], x[11][7], x[11][8], x[11][9], x[11][10], x[11][11],
        x[11][12], x[11][13], x[11][14], x[11][15], x[11][16], x[11][17], x[11][18], x[11][19],
        x[11][20], x[11][21], x[11][22], x[11][23], x[12][0], x[12][1], x[12][8], x[12][9],
        x[12][10], x[12][11], x[12][12], x[12][13], x[12][20], x[12][21], x[12][22], x[12][23],
        x[13][0], x[13][1], x[13][8], x[13][9], x[13][10], x[13][11], x[13][12], x[13][13],
        x[13][20], x[13][21], x[13][22], x[13][23]]
}

static RATE_JACOBIAN_STEPS: &[Step<'static>] = &[Step::less(2, &[(0, 33)]), Step::less(18,
    &[(1, 2)]), Step::less(0, &[(2, 18)]), Step::less(19, &[(3, 2)]), Step::less(1, &[(2, 19)]),
    Step::less(20, &[(1, 2), (2, 0)]), Step::less(21, &[(3, 2), (2, 1)]), Step::less(21,
    &[(4, 20)]), Step::less(28, &[(5, 20), (6, 21)]), Step::less(29, &[(7, 20), (8, 21), (9, 28)]),
    Step::less(32, &[(10, 28), (11, 29)]), Step::scaled(32, 12, &[]), Step::scaled(29, 13,
    &[(11, 32)]), Step::scaled(28, 14, &[(9, 29), (10, 32)]), Step::scaled(21, 15,
    &[(6, 28), (8, 29)]), Step::scaled(20, 16, &[(4, 21), (5, 28), (7, 29)]), Step::less(13,
    &[(17, 29), (18, 32)]), Step::less(12, &[(17, 28), (19, 32)]), Step::less(5,
    &[(20, 20), (21, 21), (22, 28), (23, 29)]), Step::less(4, &[(24, 21), (25, 29)]), Step::less(3,
    &[(24, 20), (25, 28)]), Step::less(22, &[(2, 3), (26, 5)]), Step::less(23, &[(2, 4), (27, 5)]),
    Step::less(23, &[(28, 22)]), Step::less(24, &[(29, 22), (30, 23)]), Step::less(25,
    &[(31, 22), (32, 23), (33, 24)]), Step::less(26, &[(34, 24), (35, 25)]), Step::less(27,
    &[(36, 24), (37, 25), (38, 26)]), Step::scaled(27, 39, &[]), Step::scaled(26, 40, &[(38, 27)]),
    Step::scaled(25, 41, &[(35, 26), (37, 27)]), Step::scaled(24, 42, &[(33, 25), (34, 26),
    (36, 27)]), Step::scaled(23, 43, &[(30, 24), (32, 25)]), Step::scaled(22, 44,
    &[(28, 23), (29, 24), (31, 25)]), Step::less(11, &[(45, 24), (46, 26), (47, 27)]),
    Step::less(10, &[(48, 25), (49, 27)]), Step::less(9, &[(50, 25), (49, 26)]), Step::less(8,
    &[(51, 22), (52, 23), (53, 24), (54, 25)]), Step::less(7, &[(55, 23), (56, 25)]), Step::less(6,
    &[(55, 22), (57, 25)])];
/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        _c: &Constants<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Wanted outputs. 234 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x,
        bobbin_y, bobbin_phi, drum_x, drum_y, drum_phi, _, _, _, _, _, _, cylinder_v_x,
        cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, ..] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let t0 = R::literal(0.1) * m.cos_post_phi;
    let t1 = ((rod_y - cylinder_y) * m.cos_cylinder_phi).sub_product(rod_x - cylinder_x,
        m.sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * m.cos_cylinder_phi).add_product(cylinder_omega, t1)
        .add_product(rod_v_y - cylinder_v_y, m.sin_cylinder_phi);
    let t2 = m.t24 * m.t22;
    let t3 = (R::literal(0.833_333_333_333_333_4) + m.t27) * m.t22;
    let t4 = m.factors[19] * m.factors[14];
    let t5 = m.t69 * m.t67;
    let t6 = (m.t83 + m.t84) * m.factors[42];
    let t7 = m.factors[47] * m.factors[42];
    let t8 = R::literal(50.0) * slide_rate;
    let t9 = p.spring_stiffness * (m.slide - p.spring_free_length);
    let t10 = (t9 * m.cos_cylinder_phi).add_product(t8, m.cos_cylinder_phi);
    let t11 = t9 * m.sin_cylinder_phi;
    let t12 = t8 * m.sin_cylinder_phi;
    let t13 = t10.add_product(R::literal(0.3), m.t150);
    let t14 = (t12 - (R::literal(2.943) - t11)).sub_product(R::literal(0.3), m.cylinder_v_y_dot);
    let t15 = (t9 * t1).add_product(t8, t1).add_product(R::literal(0.00036), m.cylinder_omega_dot);
    let t16 = t10.add_product(R::literal(0.2), m.rod_v_x_dot);
    let t17 = (-(t12 + (R::literal(1.962) + t11))).add_product(R::literal(0.2), m.t149
        .add_product(R::literal(5.0), m.t142));
    let t18 = R::literal(0.00024) * m.rod_omega_dot;
    let t19 = (m.factors[51] * t15).sub_product(R::literal(3.333_333_333_333_333_5), t13);
    let t20 = (-(R::literal(3.333_333_333_333_333_5) * t14)
        .add_product(R::literal(166.666_666_666_666_66) * m.cos_cylinder_phi, t15)).add_product(t5,
        t19);
    let t21 = (-(-m.t148).add_product(m.factors[47], m.t142))
        .add_product(R::literal(-2_777.777_777_777_778), t15).sub_product(m.factors[29], t19)
        .sub_product(m.factors[30], t20);
    let t22 = (m.cos_cylinder_phi * R::literal(3.333_333_333_333_333_5) * t14)
        .sub_product(m.factors[57], t13).sub_product(m.slide * R::literal(2_777.777_777_777_778),
        t15).sub_product(m.sin_cylinder_phi * R::literal(5.0), t16).sub_product(m.factors[48], t17)
        .add_product(m.t75, t19).sub_product(m.factors[32], t20).add_product(t6, t21);
    let t23 = (R::literal(-250.0) * m.sin_rod_phi * t18).add_product(R::literal(5.0), t16)
        .sub_product(m.factors[34], t21).sub_product(m.factors[35], t22);
    let t24 = (m.factors[47] * t18).sub_product(R::literal(5.0), t17).add_product(t7, t21)
        .add_product(m.t95, t22).add_product(m.t100, t23) * m.factors[39];
    let t25 = (-(t23 * m.t97)).add_product(m.t100, t24);
    let t26 = (t22 * m.factors[41]).sub_product(m.factors[35], t25).add_product(m.t95, t24);
    let t27 = (t21 * m.factors[42]).add_product(t6, t26).sub_product(m.factors[34], t25)
        .add_product(t7, t24);
    let t28 = (t20 * m.factors[43]).sub_product(m.factors[30], t27);
    let t29 = m.factors[32] * t26;
    let t30 = t28 - t29;
    let t31 = (-(t19 * m.t67)).add_product(t5, t30).sub_product(m.factors[29], t27)
        .add_product(m.t75, t26);
    let t32 = t31.add_product(R::literal(1.2), m.t136
        .add_product(R::literal(-0.833_333_333_333_333_4), m.t132));
    let pin_d_y = t29 - t28;
    let t33 = R::literal(-11.772).add_product(R::literal(1.2), m.t135) - pin_d_y;
    let t34 = (-(p.bobbin_radius * p.winding_force).add_product(R::literal(0.0025),
        m.plate_omega_dot).add_product(m.factors[26], t31)).add_product(R::literal(0.06)
        * m.cos_plate_phi, t30);
    let t35 = (p.winding_force * (bobbin_y - drum_y) / m.between).add_product(p.bobbin_mass,
        m.bobbin_v_x_dot);
    let t36 = (p.winding_force * (bobbin_x - drum_x) / m.between).sub_product(R::literal(9.81),
        p.bobbin_mass).sub_product(p.bobbin_mass, m.bobbin_v_y_dot);
    let t37 = (R::literal(0.833_333_333_333_333_4) * t32).add_product(m.factors[20], t34);
    let t38 = (R::literal(-0.833_333_333_333_333_4) * t33).add_product(R::literal(24.0)
        * m.cos_plate_phi, t34).sub_product(t2, t37);
    let t39 = (R::literal(0.833_333_333_333_333_4) * t32).add_product(m.t10 * R::literal(400.0),
        t34).add_product(m.factors[17], t35).sub_product(t3, t37).sub_product(m.factors[6], t38);
    let t40 = (-(R::literal(-0.833_333_333_333_333_4) * t33).add_product(m.factors[23], t34)
        .add_product(m.factors[17], t36)).add_product(m.factors[7], t37).sub_product(m.factors[8],
        t38).sub_product(m.factors[9], t39);
    let contact = (m.factors[19] * t35).sub_product(m.factors[18], t36).add_product(t4, t39)
        .sub_product(m.factors[11], t40) * m.t51;
    let t41 = (t40 * m.factors[13]).add_product(m.factors[11], contact);
    let t42 = (t39 * m.factors[14]).sub_product(m.factors[9], t41).sub_product(t4, contact);
    let t43 = (t38 * m.factors[15]).sub_product(m.factors[6], t42);
    let t44 = m.factors[8] * t41;
    let t45 = t43 - t44;
    let t46 = (t37 * m.t22).add_product(t2, t45).add_product(t3, t42);
    let t47 = m.factors[7] * t41;
    let pin_c_y = t44 - t43;
    let pin_c_x = t47 - t46;
    let pin_o_x = pin_c_x.add_product(R::literal(0.8), m.post_v_x_dot);
    let stop = m.t12 * (R::literal(-0.0027) * m.t122).add_product(m.factors[1], t46 - t47)
        .sub_product(t0, t45).sub_product(t0, R::literal(-7.848).add_product(R::literal(0.8),
        m.t125) - pin_c_y).sub_product(m.factors[1], pin_o_x);
    Outputs {
        contact_force: contact,
        stop_force: stop,
        strut_push: -(t8 + t9),
        post_angle: post_phi,
        plate_angle: plate_phi,
        bobbin_angle: bobbin_phi,
        drum_angle: drum_phi,
    }
}

/// T, V and the energy of first-order states \[J\]. 72 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, post_y, _, _, plate_y, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _, _,
        bobbin_y, _, _, drum_y, _, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y,
        plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
        bobbin_v_x, bobbin_v_y, bobbin_omega, drum_v_x, drum_v_y, drum_omega] = *state;
    let (sin_cylinder_phi, cos_cylinder_phi) = cylinder_phi.sin_cos();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t0 = (R::literal(0.00012) * (rod_omega * rod_omega)).add_product(R::literal(0.00018),
        cylinder_omega * cylinder_omega).add_product(R::literal(0.0006), drum_omega * drum_omega)
        .add_product(R::literal(0.00065), bobbin_omega * bobbin_omega)
        .add_product(R::literal(0.00125), plate_omega * plate_omega)
        .add_product(R::literal(0.00135), post_omega * post_omega).add_product(R::literal(0.1),
        (rod_v_x * rod_v_x).add_product(rod_v_y, rod_v_y)).add_product(R::literal(0.15),
        (cylinder_v_x * cylinder_v_x).add_product(cylinder_v_y, cylinder_v_y))
        .add_product(R::literal(0.4), (post_v_x * post_v_x).add_product(post_v_y, post_v_y));
    Energy {
        kinetic: t0.add_product(R::literal(0.5) * p.bobbin_mass, (bobbin_v_x * bobbin_v_x)
            .add_product(bobbin_v_y, bobbin_v_y)).add_product(R::literal(0.6),
            (plate_v_x * plate_v_x).add_product(plate_v_y, plate_v_y))
            .add_product(R::literal(0.75), (drum_v_x * drum_v_x).add_product(drum_v_y, drum_v_y)),
        potential: (R::literal(1.962) * rod_y).add_product(R::literal(0.5) * p.spring_stiffness,
            slide_minus_spring_free_length * slide_minus_spring_free_length)
            .add_product(R::literal(2.943), cylinder_y).add_product(R::literal(7.848), post_y)
            .add_product(R::literal(9.81) * p.bobbin_mass, bobbin_y)
            .add_product(R::literal(11.772), plate_y).add_product(R::literal(14.715), drum_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 114 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x, bobbin_y, _,
        drum_x, drum_y, _, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y, plate_omega,
        cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x,
        bobbin_v_y, _, _, drum_v_y, ..] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let t0 = ((rod_y - cylinder_y) * m.cos_cylinder_phi).sub_product(rod_x - cylinder_x,
        m.sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * m.cos_cylinder_phi).add_product(cylinder_omega, t0)
        .add_product(rod_v_y - cylinder_v_y, m.sin_cylinder_phi);
    let t1 = p.spring_stiffness * (m.slide - p.spring_free_length);
    let t2 = t1 * m.cos_cylinder_phi;
    let t3 = t1 * m.sin_cylinder_phi;
    let t4 = (R::literal(7.848) * post_v_y).add_product(R::literal(11.772), plate_v_y)
        .sub_product(t2, cylinder_v_x).add_product(R::literal(2.943) - t3, cylinder_v_y)
        .add_product(t1 * t0, cylinder_omega).add_product(t2, rod_v_x)
        .add_product(R::literal(1.962) + t3, rod_v_y).add_product(R::literal(9.81) * p.bobbin_mass,
        bobbin_v_y).add_product(R::literal(14.715), drum_v_y).add_product(R::literal(0.8)
        * post_v_x, m.post_v_x_dot).sub_product(R::literal(0.8) * post_v_y, m.t125)
        .sub_product(R::literal(0.0027) * post_omega, m.t122).sub_product(R::literal(1.2)
        * plate_v_x, m.t136.add_product(R::literal(-0.833_333_333_333_333_4), m.t132))
        .sub_product(R::literal(1.2) * plate_v_y, m.t135);
    PowerBalance {
        stored_rate: t4.add_product(R::literal(0.0025) * plate_omega, m.plate_omega_dot)
            .sub_product(R::literal(0.3) * cylinder_v_x, m.t150).add_product(R::literal(0.3)
            * cylinder_v_y, m.cylinder_v_y_dot).add_product(R::literal(0.00036) * cylinder_omega,
            m.cylinder_omega_dot).add_product(R::literal(0.2) * rod_v_x, m.rod_v_x_dot)
            .sub_product(R::literal(0.2) * rod_v_y, m.t149.add_product(R::literal(5.0), m.t142))
            .add_product(R::literal(0.00024) * rod_omega, m.rod_omega_dot)
            .add_product(p.bobbin_mass * bobbin_v_x, m.bobbin_v_x_dot).add_product(p.bobbin_mass
            * bobbin_v_y, m.bobbin_v_y_dot),
        supplied: (p.winding_force * bobbin_v_y * (bobbin_x - drum_x) / m.between)
            .sub_product(p.bobbin_radius * p.winding_force, plate_omega) - p.winding_force
            * bobbin_v_x * (bobbin_y - drum_y) / m.between,
        dissipated: (R::literal(50.0) * cylinder_omega * slide_rate * t0)
            .add_product(R::literal(50.0) * rod_v_x * slide_rate, m.cos_cylinder_phi)
            .add_product(R::literal(50.0) * rod_v_y * slide_rate, m.sin_cylinder_phi)
            .sub_product(R::literal(50.0) * cylinder_v_x * slide_rate, m.cos_cylinder_phi)
            .sub_product(R::literal(50.0) * cylinder_v_y * slide_rate, m.sin_cylinder_phi),
    }
}

/// `g` of each constraint, zero for those of velocities alone. 62 operations.
#[must_use]
pub fn constraint_values<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [post_x, post_y, post_phi, plate_x, plate_y, plate_phi, cylinder_x, cylinder_y,
        cylinder_phi, rod_x, rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, ..] = *state;
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
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y).sqrt();
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
    let axle_b_x_value = drum_x - R::literal(0.328);
    let axle_b_y_value = drum_y - R::literal(0.058);
    let contact_value = between - R::literal(0.04) - p.bobbin_radius;
    let stop_value = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044),
        cos_post_phi);
    [post_start_x, post_start_y, pin_c_x_value, pin_c_y_value, pin_d_x_value, pin_d_y_value,
        slide_angle_value, slide_across_value, rod_end_x, pin_e_y_value, axle_a_x_value,
        axle_a_y_value, axle_b_x_value, axle_b_y_value, contact_value, stop_value]
}

/// `g'` of each constraint. 89 operations.
#[must_use]
pub fn constraint_rates<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y, post_omega,
        plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y).sqrt();
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
    let contact_rate = (bobbin_x * bobbin_v_x).add_product(bobbin_y, bobbin_v_y)
        .add_product(drum_x, drum_v_x).add_product(drum_y, drum_v_y).sub_product(bobbin_x, drum_v_x)
        .sub_product(bobbin_y, drum_v_y).sub_product(drum_x, bobbin_v_x).sub_product(drum_y,
        bobbin_v_y) / between;
    let stop_rate = post_omega * (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143),
        cos_post_phi);
    [pin_o_x_rate, pin_o_y_rate, pin_c_x_rate, pin_c_y_rate, pin_d_x_rate, pin_d_y_rate,
        slide_angle_rate, slide_across_rate, pin_e_x_rate, pin_e_y_rate, axle_a_x_rate,
        axle_a_y_rate, drum_v_x, drum_v_y, contact_rate, stop_rate]
}

/// `G = dg'/dq'`, values in the order of its pattern. 43 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 44] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi), (sin_cylinder_phi,
        cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([post_phi, plate_phi,
        cylinder_phi, rod_phi]);
    let t0 = R::literal(0.1) * sin_post_phi;
    let t1 = R::literal(0.06) * sin_plate_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y).sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi).add_product(rod_y - cylinder_y,
        sin_cylinder_phi);
    let t2 = R::literal(-0.1) * cos_post_phi;
    let t3 = R::literal(-0.06) * cos_plate_phi;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    [R::literal(1.0), t0, R::literal(1.0), t2, R::literal(-1.0), t0, R::literal(1.0), t1,
        R::literal(-1.0), t2, R::literal(1.0), t3, R::literal(-1.0), t1, R::literal(1.0),
        R::literal(0.06) * sin_cylinder_phi, R::literal(-1.0), t3, R::literal(1.0),
        R::literal(-0.06) * cos_cylinder_phi, R::literal(-1.0), R::literal(1.0), sin_cylinder_phi,
        -cos_cylinder_phi, -slide, -sin_cylinder_phi, cos_cylinder_phi, R::literal(1.0),
        R::literal(-0.06) * sin_rod_phi, R::literal(1.0), R::literal(0.06) * cos_rod_phi,
        R::literal(-1.0), (R::literal(-0.01) * sin_plate_phi).sub_product(R::literal(0.1),
        cos_plate_phi), R::literal(1.0), R::literal(-1.0), (R::literal(0.01)
        * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), bobbin_x_minus_drum_x_over_between,
        bobbin_y_minus_drum_y_over_between, -bobbin_x_minus_drum_x_over_between,
        -bobbin_y_minus_drum_y_over_between, (R::literal(0.044)
        * sin_post_phi).add_product(R::literal(0.143), cos_post_phi)]
}
