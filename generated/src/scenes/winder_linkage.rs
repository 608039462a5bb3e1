// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   15aae97806f290d2a0c9e068e0de20b91e65e5561e986616897e05eee65d1c2e  scenes/winder_linkage.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//   aa0e8a999f462eeff001756527f878c9e91be49559e9f536983ca628c62c89a6  units/spring_damper.toml
//
// Four-link bobbin holder, at work
//
// The holder of a self-twist spinning machine: post OC, plate ACD that carries the bobbin at
// A, and a strut D-S-E, a spring and an oil damper in a cylinder that slides on a rod. The
// bobbin rests on the drum at K, the post on a stop at T. All six bodies are free in the
// plane and held by fourteen constraints of pins and slide and by the two of the contacts,
// whose forces are N and Q; the holder works steadily while both are above zero.
//
// The study gives no dimensions; these are plausible ones.
//
// Source:
//   Study of a winding mechanism; dimensions are ours.
//
// All quantities are in SI units.
// Shapes: coordinates 18, states 36, parameters 5, outputs 7, constraints 16.
// Nonzeros: mass_matrix 18 of 18 by 18, rate_jacobian 402 of 36 by 36,
//     parameter_jacobian 80 of 36 by 5, constraint_matrix 44 of 16 by 18.
// Operations: rate 982, forcing 49, rate_jacobian 7206, parameter_jacobian 2128, outputs 780,
//     energy 72, power_balance 1074, constraint_values 62, constraint_rates 89, constraint_matrix 43,
//     prepare 4, prepared_rate 978, prepared_rate_jacobian 7202.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Four-link bobbin holder, at work
    ///
    /// The holder of a self-twist spinning machine: post OC, plate ACD that carries the bobbin at
    /// A, and a strut D-S-E, a spring and an oil damper in a cylinder that slides on a rod. The
    /// bobbin rests on the drum at K, the post on a stop at T. All six bodies are free in the
    /// plane and held by fourteen constraints of pins and slide and by the two of the contacts,
    /// whose forces are N and Q; the holder works steadily while both are above zero.
    ///
    /// The study gives no dimensions; these are plausible ones.
    ///
    /// Source: Study of a winding mechanism; dimensions are ours.
    WinderLinkage: "winder_linkage", "Four-link bobbin holder, at work";
    run from 0.0, until 1.0, points 101, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared;
}

::machinist_contract::parameters! {
    bobbin_radius: 0.06, "m", "bobbin_radius", "radius of the package on the bobbin";
    winding_force: 0.0, "N", "winding_force", "force of the drum on the bobbin along its surface, to the left over the drum";
    bobbin_mass: 0.7, "kg", "bobbin.mass", "the mass";
    spring_stiffness: 2000.0, "N/m", "spring.stiffness", "spring";
    spring_free_length: 0.116, "m", "spring.free_length", "distance at which the spring is at rest";
}

::machinist_contract::outputs! {
    contact_force: "N", "contact_force", "N, force of the drum on the bobbin at K";
    stop_force: "N", "stop_force", "Q, force of the stop on the post at T";
    strut_push: "N", "strut_push", "force with which it pushes its ends apart";
    post_angle: "rad", "post_angle", "angle of the bar from sideways";
    plate_angle: "rad", "plate_angle", "angle of the bar from sideways";
    bobbin_angle: "rad", "bobbin_angle", "angle of the bar from sideways";
    drum_angle: "rad", "drum_angle", "angle of the bar from sideways";
}

::machinist_contract::states! {
    POST_X: position guess, 0.1, "m", "post.x", "centre of mass, sideways";
    POST_Y: position guess, 0.1, "m", "post.y", "centre of mass, upwards";
    POST_PHI: position guess, 1.0, "rad", "post.phi", "angle of the bar from sideways";
    PLATE_X: position guess, 0.1, "m", "plate.x", "centre of mass, sideways";
    PLATE_Y: position guess, 0.1, "m", "plate.y", "centre of mass, upwards";
    PLATE_PHI: position guess, 1.0, "rad", "plate.phi", "angle of the bar from sideways";
    CYLINDER_X: position guess, 0.1, "m", "cylinder.x", "centre of mass, sideways";
    CYLINDER_Y: position guess, 0.1, "m", "cylinder.y", "centre of mass, upwards";
    CYLINDER_PHI: position guess, 1.0, "rad", "cylinder.phi", "angle of the bar from sideways";
    ROD_X: position guess, 0.1, "m", "rod.x", "centre of mass, sideways";
    ROD_Y: position guess, 0.1, "m", "rod.y", "centre of mass, upwards";
    ROD_PHI: position guess, 1.0, "rad", "rod.phi", "angle of the bar from sideways";
    BOBBIN_X: position guess, 0.1, "m", "bobbin.x", "centre of mass, sideways";
    BOBBIN_Y: position guess, 0.1, "m", "bobbin.y", "centre of mass, upwards";
    BOBBIN_PHI: position guess, 1.0, "rad", "bobbin.phi", "angle of the bar from sideways";
    DRUM_X: position guess, 0.1, "m", "drum.x", "centre of mass, sideways";
    DRUM_Y: position guess, 0.1, "m", "drum.y", "centre of mass, upwards";
    DRUM_PHI: position guess, 1.0, "rad", "drum.phi", "angle of the bar from sideways";
    POST_V_X: velocity guess, 1.0, "m/s", "post.v_x", "rate of centre of mass, sideways";
    POST_V_Y: velocity guess, 1.0, "m/s", "post.v_y", "rate of centre of mass, upwards";
    POST_OMEGA: velocity guess, 10.0, "rad/s", "post.omega", "rate of angle of the bar from sideways";
    PLATE_V_X: velocity guess, 1.0, "m/s", "plate.v_x", "rate of centre of mass, sideways";
    PLATE_V_Y: velocity guess, 1.0, "m/s", "plate.v_y", "rate of centre of mass, upwards";
    PLATE_OMEGA: velocity guess, 10.0, "rad/s", "plate.omega", "rate of angle of the bar from sideways";
    CYLINDER_V_X: velocity guess, 1.0, "m/s", "cylinder.v_x", "rate of centre of mass, sideways";
    CYLINDER_V_Y: velocity guess, 1.0, "m/s", "cylinder.v_y", "rate of centre of mass, upwards";
    CYLINDER_OMEGA: velocity guess, 10.0, "rad/s", "cylinder.omega", "rate of angle of the bar from sideways";
    ROD_V_X: velocity guess, 1.0, "m/s", "rod.v_x", "rate of centre of mass, sideways";
    ROD_V_Y: velocity guess, 1.0, "m/s", "rod.v_y", "rate of centre of mass, upwards";
    ROD_OMEGA: velocity guess, 10.0, "rad/s", "rod.omega", "rate of angle of the bar from sideways";
    BOBBIN_V_X: velocity guess, 1.0, "m/s", "bobbin.v_x", "rate of centre of mass, sideways";
    BOBBIN_V_Y: velocity guess, 1.0, "m/s", "bobbin.v_y", "rate of centre of mass, upwards";
    BOBBIN_OMEGA: velocity, 10.0, "rad/s", "bobbin.omega", "rate of angle of the bar from sideways";
    DRUM_V_X: velocity guess, 1.0, "m/s", "drum.v_x", "rate of centre of mass, sideways";
    DRUM_V_Y: velocity guess, 1.0, "m/s", "drum.v_y", "rate of centre of mass, upwards";
    DRUM_OMEGA: velocity, 10.0, "rad/s", "drum.omega", "rate of angle of the bar from sideways";
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
    "axle_b_x": of_positions, "m", "axle B of the drum in the frame, sideways";
    "axle_b_y": of_positions, "m", "axle B of the drum in the frame, upwards";
    "contact": of_positions, "m", "K: the bobbin touches the drum";
    "stop": of_positions, "m", "T: the post touches its stop";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 18 by 18 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] 8 [8] 9 [9]
        10 [10] 11 [11] 12 [12] 13 [13] 14 [14] 15 [15] 16 [16] 17 [17] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 36 by 36 { 0 [18] 1 [19] 2 [20] 3 [21] 4 [22] 5 [23] 6 [24] 7 [25]
        8 [26] 9 [27] 10 [28] 11 [29] 12 [30] 13 [31] 14 [32] 15 [33] 16 [34] 17 [35]
        18 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        19 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        20 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        21 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        22 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        23 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        24 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        25 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        26 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        27 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        28 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        29 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        30 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        31 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        33 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34]
        34 [2 5 6 7 8 9 10 11 12 13 15 16 20 23 24 25 26 27 28 29 30 31 33 34] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 36 by 5 { 18 [0 1 2 3 4] 19 [0 1 2 3 4] 20 [0 1 2 3 4]
        21 [0 1 2 3 4] 22 [0 1 2 3 4] 23 [0 1 2 3 4] 24 [0 1 2 3 4] 25 [0 1 2 3 4] 26 [0 1 2 3 4]
        27 [0 1 2 3 4] 28 [0 1 2 3 4] 29 [0 1 2 3 4] 30 [0 1 2 3 4] 31 [0 1 2 3 4] 33 [0 1 2 3 4]
        34 [0 1 2 3 4] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 16 by 18 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6 8]
        5 [4 5 7 8] 6 [8 11] 7 [6 7 8 9 10] 8 [9 11] 9 [10 11] 10 [3 5 12] 11 [4 5 13] 12 [15]
        13 [16] 14 [12 13 15 16] 15 [2] }
}

::machinist_contract::constants! {
    inverse_bobbin_mass, bobbin_radius_times_winding_force, t0, t1
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run. 4 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t0 = R::literal(9.81) * p.bobbin_mass;
    let t1 = bobbin_radius_times_winding_force * R::literal(400.0);
    Constants { inverse_bobbin_mass, bobbin_radius_times_winding_force, t0, t1 }
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

/// As `rate`, with the constants of the parameters from `prepare`. 978 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y, post_omega,
        plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega, drum_v_x, drum_v_y, drum_omega]
        = *state;
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
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t7 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t7)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t8 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t9 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t10 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t11 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t12 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t13 = t8 * R::literal(370.370_370_370_370_3);
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = t9 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t19 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t21 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t22 = slide * R::literal(2_777.777_777_777_778);
    let t23 = sin_cylinder_phi * R::literal(5.0);
    let t24 = cos_cylinder_phi * R::literal(5.0);
    let t25 = R::literal(250.0) * sin_rod_phi;
    let t26 = R::literal(250.0) * cos_rod_phi;
    let t27 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t28 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t29 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t30 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = t11 * t1;
    let t32 = R::literal(1.25) + t31;
    let t33 = R::literal(1.0) / t32;
    let t34 = t12 * t1;
    let t35 = t34 * t33;
    let t36 = R::literal(1.25) - t31;
    let t37 = t36 * t33;
    let t38 = t13 * t1;
    let t39 = t38 * t33;
    let t40 = t12 * t0;
    let t41 = R::literal(1.25) + t40;
    let t42 = t35 * t34;
    let t43 = R::literal(1.0) / (t42 - t41);
    let t44 = (t11 * t0).add_product(t37, t34);
    let t45 = t44 * t43;
    let t46 = R::literal(1.25) - t40 + t42;
    let t47 = t46 * t43;
    let t48 = (t13 * t0).sub_product(t39, t34);
    let t49 = t48 * t43;
    let t50 = t14 * t3;
    let t51 = R::literal(1.0) / (-(t32 + R::literal(0.833_333_333_333_333_4) + t50))
        .add_product(t37, t36).sub_product(t45, t44);
    let t52 = t15 * t3;
    let t53 = (t34 + t52).add_product(t35, t36).sub_product(t47, t44);
    let t54 = t53 * t51;
    let t55 = R::literal(0.833_333_333_333_333_4) - t50;
    let t56 = t55 * t51;
    let t57 = t52 * t51;
    let t58 = t16 * t3;
    let t59 = R::literal(0.833_333_333_333_333_4) + t58;
    let t60 = t59 * t51;
    let t61 = t17 * t3;
    let t62 = t61 * t51;
    let t63 = t38.add_product(t39, t36).add_product(t49, t44);
    let t64 = t63 * t51;
    let t65 = t15 * t2;
    let t66 = R::literal(1.0) / (t42 - (t41 + R::literal(0.833_333_333_333_333_4) + t65))
        .sub_product(t47, t46).sub_product(t54, t53);
    let t67 = (t14 * t2).sub_product(t56, t53);
    let t68 = t67 * t66;
    let t69 = (R::literal(0.833_333_333_333_333_4) - t65).sub_product(t57, t53);
    let t70 = t69 * t66;
    let t71 = t16 * t2;
    let t72 = t71.add_product(t60, t53);
    let t73 = t72 * t66;
    let t74 = t17 * t2;
    let t75 = (R::literal(0.833_333_333_333_333_4) + t74).add_product(t62, t53);
    let t76 = t75 * t66;
    let t77 = t48.sub_product(t49, t46).add_product(t64, t53);
    let t78 = t77 * t66;
    let t79 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t50
        + R::literal(3.333_333_333_333_333_5)).add_product(t20, t5).add_product(t56, t55)
        .add_product(t68, t67);
    let t80 = t52.add_product(t21, t5).sub_product(t57, t55).sub_product(t70, t67);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = (-t18).add_product(t22, t5);
    let t85 = t84 * t79;
    let t86 = (t58 - R::literal(0.833_333_333_333_333_4)).sub_product(t60, t55).add_product(t73,
        t67);
    let t87 = t86 * t79;
    let t88 = (-t61).add_product(t62, t55).sub_product(t76, t67);
    let t89 = t88 * t79;
    let t90 = (t64 * t55).sub_product(t78, t67);
    let t91 = t90 * t79;
    let t92 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t65
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t4).add_product(t57, t52)
        .add_product(t70, t69)).add_product(t81, t80);
    let t93 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t83, t80);
    let t94 = t93 * t92;
    let t95 = t19.sub_product(t22, t4).add_product(t85, t80);
    let t96 = t95 * t92;
    let t97 = (-t71.add_product(t60, t52)).add_product(t73, t69).add_product(t87, t80);
    let t98 = t97 * t92;
    let t99 = (t74 - R::literal(0.833_333_333_333_333_4)).add_product(t62, t52).sub_product(t76,
        t69).add_product(t89, t80);
    let t100 = t99 * t92;
    let t101 = (t64 * t52).sub_product(t78, t69).add_product(t91, t80);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t83, t82)
        .sub_product(t94, t93);
    let t104 = t22.add_product(t85, t82).add_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t25 * t103;
    let t107 = t26 * t103;
    let t108 = (t87 * t82).add_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t82).add_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t82).add_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t18 * sin_cylinder_phi).add_product(t19, cos_cylinder_phi)
        .add_product(t22, slide).add_product(t23, sin_cylinder_phi).add_product(t24,
        cos_cylinder_phi)).add_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t23.add_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = t24.add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (t87 * t84).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (t89 * t84).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (t91 * t84).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(5.0).add_product(t25, t6).add_product(t106, t25)
        .add_product(t116, t115);
    let t126 = (t26 * t6).add_product(t107, t25).add_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (t109 * t25).sub_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (t111 * t25).sub_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (t113 * t25).sub_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / (-R::literal(5.0).add_product(t26, R::literal(0.06) * cos_rod_phi)
        .add_product(t107, t26).add_product(t118, t117)).add_product(t127, t126);
    let t135 = (-(t109 * t26)).add_product(t120, t117).add_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (-(t111 * t26)).add_product(t122, t117).add_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (-(t113 * t26)).add_product(t124, t117).add_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t16, t9)
        + c.inverse_bobbin_mass).add_product(t60, t59).add_product(t73, t72)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t17 * t9).add_product(t62, t59).add_product(t76, t72).add_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).add_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t27 * t141;
    let t145 = (t64 * t59).add_product(t78, t72).add_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).add_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + c.inverse_bobbin_mass).add_product(t62, t61).add_product(t76, t75)).add_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).add_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t28).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (-(t64 * t61).add_product(t78, t75)).add_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).add_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t29 * bobbin_x_minus_drum_x_over_between;
    let t153 = t30 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (t152 - ((t27 * bobbin_x_minus_drum_x_over_between)
        .add_product(t28, bobbin_y_minus_drum_y_over_between) + t152 + t153).add_product(t144, t27)
        .add_product(t149, t148) + t153);
    let t155 = (t146 * t27).sub_product(t151, t148);
    let t156 = t155 * t154;
    let t157 = R::literal(50.0) * slide_rate;
    let t158 = p.spring_stiffness * (slide - p.spring_free_length);
    let t159 = (t158 * cos_cylinder_phi).add_product(t157, cos_cylinder_phi);
    let t160 = t158 * sin_cylinder_phi;
    let t161 = t157 * sin_cylinder_phi;
    let t162 = t161 - (R::literal(2.943) - t160);
    let t163 = (t158 * t7).add_product(t157, t7);
    let t164 = t161 + (R::literal(1.962) + t160);
    let t165 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t166 = p.winding_force * bobbin_x_minus_drum_x / between - c.t0;
    let post_omega_squared = post_omega * post_omega;
    let t167 = R::literal(0.1) * post_omega_squared;
    let t168 = t167 * cos_post_phi;
    let t169 = t167 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t170 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t171 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t172 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t173 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t174 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t175 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t176 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t177 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t178 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t179 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t180 = (bobbin_v_x * (bobbin_v_x_over_between + t174 + t175 - t172 - t173
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t178 + t179
        - t176 - t177 - drum_v_y_over_between).add_product(drum_v_x, t172 + t173
        + drum_v_x_over_between - bobbin_v_x_over_between - t174 - t175).add_product(drum_v_y, t176
        + t177 + drum_v_y_over_between - bobbin_v_y_over_between - t178 - t179);
    let t181 = t35 * t168;
    let t182 = R::literal(9.81) - t169 - t181;
    let t183 = t14 * c.bobbin_radius_times_winding_force;
    let t184 = (t183 - t168.add_product(t170, cos_plate_phi)).sub_product(t37, t168)
        .sub_product(t45, t182);
    let t185 = t15 * c.bobbin_radius_times_winding_force;
    let t186 = (R::literal(9.81) - (t169.add_product(t170, sin_plate_phi) + R::literal(9.81))
        - t185 - t181).sub_product(t47, t182).sub_product(t54, t184);
    let t187 = R::literal(3.333_333_333_333_333_5) * t159;
    let t188 = (t183.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) - t187).add_product(t20, t163)
        .sub_product(t56, t184).sub_product(t68, t186);
    let t189 = R::literal(3.333_333_333_333_333_5) * t162;
    let t190 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t185 + t189)
        .add_product(t21, t163).add_product(t57, t184).add_product(t70, t186)).add_product(t81,
        t188);
    let t191 = (R::literal(-2_777.777_777_777_778) * t163).sub_product(t83, t188).sub_product(t94,
        t190);
    let t192 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t159)
        .add_product(t19, t162).sub_product(t22, t163).sub_product(t23, t159).add_product(t24, t164)
        .add_product(t85, t188).sub_product(t96, t190);
    let t193 = t192.add_product(t105, t191);
    let t194 = R::literal(5.0) * t159;
    let t195 = t194.add_product(t171, cos_rod_phi).sub_product(t106, t191).sub_product(t116, t193);
    let t196 = R::literal(5.0) * t164;
    let t197 = t196.add_product(t171, sin_rod_phi).add_product(t107, t191).add_product(t118, t193)
        .add_product(t127, t195);
    let t198 = c.inverse_bobbin_mass * t165;
    let t199 = ((t10 * plate_omega_squared).sub_product(t16, c.bobbin_radius_times_winding_force)
        + t198).sub_product(t60, t184).add_product(t73, t186).add_product(t87, t188)
        .sub_product(t98, t190).add_product(t109, t191).sub_product(t120, t193).add_product(t129,
        t195).sub_product(t136, t197);
    let t200 = c.inverse_bobbin_mass * t166;
    let t201 = (R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        c.bobbin_radius_times_winding_force) - t200).add_product(t62, t184).sub_product(t76, t186)
        .add_product(t89, t188).sub_product(t100, t190).add_product(t111, t191).sub_product(t122,
        t193).add_product(t131, t195).sub_product(t138, t197).sub_product(t143, t199);
    let t202 = (-t180).add_product(t27, t165).sub_product(t28, t166)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t144, t199).sub_product(t149, t201)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t203 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t39, t168).sub_product(t49, t182).add_product(t64, t184)
        .sub_product(t78, t186).add_product(t91, t188).sub_product(t102, t190).add_product(t113,
        t191).sub_product(t124, t193).add_product(t133, t195).sub_product(t140, t197)
        .sub_product(t146, t199).sub_product(t151, t201).sub_product(t156, t202);
    let t204 = t203 * (R::literal(1.0) / (-(t13 * t8)).add_product(t39, t38).sub_product(t49, t48)
        .sub_product(t64, t63).sub_product(t78, t77).add_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).add_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155));
    let t205 = (t202 * t154).sub_product(t156, t204);
    let t206 = (t201 * t147).sub_product(t149, t205).sub_product(t151, t204);
    let t207 = (t199 * t141).sub_product(t143, t206).add_product(t144, t205).sub_product(t146,
        t204);
    let t208 = (t197 * t134).sub_product(t136, t207).sub_product(t138, t206).sub_product(t140,
        t204);
    let t209 = (-(t195 * t125)).add_product(t127, t208).add_product(t129, t207).add_product(t131,
        t206).add_product(t133, t204);
    let t210 = (t193 * t114).sub_product(t116, t209).add_product(t118, t208).sub_product(t120, t207)
        .sub_product(t122, t206).sub_product(t124, t204);
    let t211 = (t191 * t103).add_product(t105, t210).sub_product(t106, t209).add_product(t107, t208)
        .add_product(t109, t207).add_product(t111, t206).add_product(t113, t204);
    let t212 = (t190 * t92).sub_product(t94, t211).sub_product(t96, t210).sub_product(t98, t207)
        .sub_product(t100, t206).sub_product(t102, t204);
    let t213 = (-(t188 * t79)).add_product(t81, t212).sub_product(t83, t211).add_product(t85, t210)
        .add_product(t87, t207).add_product(t89, t206).add_product(t91, t204);
    let t214 = (t186 * t66).sub_product(t68, t213).sub_product(t70, t212).add_product(t73, t207)
        .sub_product(t76, t206).sub_product(t78, t204);
    let t215 = (t184 * t51).sub_product(t54, t214).sub_product(t56, t213).sub_product(t57, t212)
        .sub_product(t60, t207).add_product(t62, t206).add_product(t64, t204);
    let t216 = (t182 * t43).sub_product(t45, t215).sub_product(t47, t214).sub_product(t49, t204);
    let t217 = (t168 * t33).add_product(t35, t216).add_product(t37, t215).add_product(t35, t214)
        .sub_product(t39, t204);
    let drum_v_y_dot = (-R::literal(9.809_999_999_999_999)
        .add_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t205))).add_product(t30, t205);
    let drum_v_x_dot = (t29 * t205).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t205);
    let bobbin_v_y_dot = t200.sub_product(c.inverse_bobbin_mass, t206).sub_product(t28, t205);
    let bobbin_v_x_dot = -t198.add_product(c.inverse_bobbin_mass, t207).add_product(t27, t205);
    let rod_omega_dot = (t25 * t209).sub_product(R::literal(4_166.666_666_666_667), t211)
        .sub_product(t26, t208);
    let rod_v_y_dot = (-t196.add_product(t24, t210)).add_product(R::literal(-5.0), t208);
    let rod_v_x_dot = (-t194).add_product(t23, t210).sub_product(R::literal(5.0), t209);
    let cylinder_omega_dot = (-(t163 * R::literal(2_777.777_777_777_778)).add_product(t20, t213))
        .add_product(t21, t212).sub_product(R::literal(-2_777.777_777_777_778), t211)
        .add_product(t22, t210);
    let cylinder_v_y_dot = t189.sub_product(R::literal(3.333_333_333_333_333_5), t212)
        .add_product(t19, t210);
    let cylinder_v_x_dot = t187.sub_product(R::literal(3.333_333_333_333_333_5), t213)
        .sub_product(t18, t210);
    let plate_omega_dot = (-c.t1.add_product(t14, t215)).add_product(t15, t214).sub_product(t14,
        t213).add_product(t15, t212).add_product(t16, t207).sub_product(t17, t206);
    let plate_v_y_dot = R::literal(-9.81).sub_product(R::literal(0.833_333_333_333_333_4), t214)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t212)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t206);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t213)
        .add_product(R::literal(-0.833_333_333_333_333_4), t215)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t207);
    let post_omega_dot = (t12 * t216).sub_product(t11, t217).sub_product(t11, t215)
        .add_product(t12, t214).sub_product(t13, t204);
    let post_v_y_dot = R::literal(-9.81).sub_product(R::literal(1.25), t216)
        .sub_product(R::literal(-1.25), t214);
    let post_v_x_dot = (R::literal(1.25) * t215).add_product(R::literal(-1.25), t217);
    [post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
        cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega,
        drum_v_x, drum_v_y, drum_omega, post_v_x_dot, post_v_y_dot, post_omega_dot, plate_v_x_dot,
        plate_v_y_dot, plate_omega_dot, cylinder_v_x_dot, cylinder_v_y_dot, cylinder_omega_dot,
        rod_v_x_dot, rod_v_y_dot, rod_omega_dot, bobbin_v_x_dot, bobbin_v_y_dot, R::literal(0.0),
        drum_v_x_dot, drum_v_y_dot, R::literal(0.0)]
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

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 7202 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 402] {
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
    let t6 = R::literal(0.06) * cos_rod_phi;
    let t7 = R::literal(0.06) * sin_rod_phi;
    let t8 = R::literal(0.01) * cos_plate_phi;
    let t9 = R::literal(0.1) * sin_plate_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t10 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t11 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t12 = t11 - t10;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi).add_product(cylinder_omega,
        t12).add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let t13 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t14 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t15 = t9 - t8;
    let t16 = t8 - t9;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t17 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t18 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t19 = t13 * R::literal(370.370_370_370_370_3);
    let t20 = R::literal(24.0) * sin_plate_phi;
    let t21 = R::literal(24.0) * cos_plate_phi;
    let t22 = t14 * R::literal(400.0);
    let t23 = t16 * R::literal(400.0);
    let t24 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t25 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t26 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t27 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t28 = slide * R::literal(2_777.777_777_777_778);
    let t29 = sin_cylinder_phi * R::literal(5.0);
    let t30 = cos_cylinder_phi * R::literal(5.0);
    let t31 = R::literal(250.0) * sin_rod_phi;
    let t32 = R::literal(250.0) * cos_rod_phi;
    let t33 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t34 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t35 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t36 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t37 = t17 * t1;
    let t38 = R::literal(1.25) + t37;
    let t39 = R::literal(1.0) / t38;
    let t40 = t18 * t1;
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t37;
    let t43 = t42 * t39;
    let t44 = t19 * t1;
    let t45 = t44 * t39;
    let t46 = t18 * t0;
    let t47 = R::literal(1.25) + t46;
    let t48 = t41 * t40;
    let t49 = R::literal(1.0) / (t48 - t47);
    let t50 = (t17 * t0).add_product(t43, t40);
    let t51 = t50 * t49;
    let t52 = R::literal(1.25) - t46 + t48;
    let t53 = t52 * t49;
    let t54 = (t19 * t0).sub_product(t45, t40);
    let t55 = t54 * t49;
    let t56 = t20 * t3;
    let t57 = R::literal(1.0) / (-(t38 + R::literal(0.833_333_333_333_333_4) + t56))
        .add_product(t43, t42).sub_product(t51, t50);
    let t58 = t21 * t3;
    let t59 = (t40 + t58).add_product(t41, t42).sub_product(t53, t50);
    let t60 = t59 * t57;
    let t61 = R::literal(0.833_333_333_333_333_4) - t56;
    let t62 = t61 * t57;
    let t63 = t58 * t57;
    let t64 = t22 * t3;
    let t65 = R::literal(0.833_333_333_333_333_4) + t64;
    let t66 = t65 * t57;
    let t67 = t23 * t3;
    let t68 = t67 * t57;
    let t69 = t44.add_product(t45, t42).add_product(t55, t50);
    let t70 = t69 * t57;
    let t71 = t21 * t2;
    let t72 = R::literal(1.0) / (t48 - (t47 + R::literal(0.833_333_333_333_333_4) + t71))
        .sub_product(t53, t52).sub_product(t60, t59);
    let t73 = (t20 * t2).sub_product(t62, t59);
    let t74 = t73 * t72;
    let t75 = (R::literal(0.833_333_333_333_333_4) - t71).sub_product(t63, t59);
    let t76 = t75 * t72;
    let t77 = t22 * t2;
    let t78 = t77.add_product(t66, t59);
    let t79 = t78 * t72;
    let t80 = t23 * t2;
    let t81 = (R::literal(0.833_333_333_333_333_4) + t80).add_product(t68, t59);
    let t82 = t81 * t72;
    let t83 = t54.sub_product(t55, t52).add_product(t70, t59);
    let t84 = t83 * t72;
    let t85 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t56
        + R::literal(3.333_333_333_333_333_5)).add_product(t26, t5).add_product(t62, t61)
        .add_product(t74, t73);
    let t86 = t58.add_product(t27, t5).sub_product(t63, t61).sub_product(t76, t73);
    let t87 = t86 * t85;
    let t88 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t89 = t88 * t85;
    let t90 = (-t24).add_product(t28, t5);
    let t91 = t90 * t85;
    let t92 = (t64 - R::literal(0.833_333_333_333_333_4)).sub_product(t66, t61).add_product(t79,
        t73);
    let t93 = t92 * t85;
    let t94 = (-t67).add_product(t68, t61).sub_product(t82, t73);
    let t95 = t94 * t85;
    let t96 = (t70 * t61).sub_product(t84, t73);
    let t97 = t96 * t85;
    let t98 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t71
        + R::literal(3.333_333_333_333_333_5)).add_product(t27, t4).add_product(t63, t58)
        .add_product(t76, t75)).add_product(t87, t86);
    let t99 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t89, t86);
    let t100 = t99 * t98;
    let t101 = t25.sub_product(t28, t4).add_product(t91, t86);
    let t102 = t101 * t98;
    let t103 = (-t77.add_product(t66, t58)).add_product(t79, t75).add_product(t93, t86);
    let t104 = t103 * t98;
    let t105 = (t80 - R::literal(0.833_333_333_333_333_4)).add_product(t68, t58).sub_product(t82,
        t75).add_product(t95, t86);
    let t106 = t105 * t98;
    let t107 = (t70 * t58).sub_product(t84, t75).add_product(t97, t86);
    let t108 = t107 * t98;
    let t109 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t89, t88)
        .sub_product(t100, t99);
    let t110 = t28.add_product(t91, t88).add_product(t102, t99);
    let t111 = t110 * t109;
    let t112 = t31 * t109;
    let t113 = t32 * t109;
    let t114 = (t93 * t88).add_product(t104, t99);
    let t115 = t114 * t109;
    let t116 = (t95 * t88).add_product(t106, t99);
    let t117 = t116 * t109;
    let t118 = (t97 * t88).add_product(t108, t99);
    let t119 = t118 * t109;
    let t120 = R::literal(1.0) / (-(t24 * sin_cylinder_phi).add_product(t25, cos_cylinder_phi)
        .add_product(t28, slide).add_product(t29, sin_cylinder_phi).add_product(t30,
        cos_cylinder_phi)).add_product(t91, t90).sub_product(t102, t101).sub_product(t111, t110);
    let t121 = t29.add_product(t112, t110);
    let t122 = t121 * t120;
    let t123 = t30.add_product(t113, t110);
    let t124 = t123 * t120;
    let t125 = (t93 * t90).sub_product(t104, t101).sub_product(t115, t110);
    let t126 = t125 * t120;
    let t127 = (t95 * t90).sub_product(t106, t101).sub_product(t117, t110);
    let t128 = t127 * t120;
    let t129 = (t97 * t90).sub_product(t108, t101).sub_product(t119, t110);
    let t130 = t129 * t120;
    let t131 = R::literal(1.0) / R::literal(5.0).add_product(t31, t7).add_product(t112, t31)
        .add_product(t122, t121);
    let t132 = (t32 * t7).add_product(t113, t31).add_product(t124, t121);
    let t133 = t132 * t131;
    let t134 = (t115 * t31).sub_product(t126, t121);
    let t135 = t134 * t131;
    let t136 = (t117 * t31).sub_product(t128, t121);
    let t137 = t136 * t131;
    let t138 = (t119 * t31).sub_product(t130, t121);
    let t139 = t138 * t131;
    let t140 = R::literal(1.0) / (-R::literal(5.0).add_product(t32, t6).add_product(t113, t32)
        .add_product(t124, t123)).add_product(t133, t132);
    let t141 = (-(t115 * t32)).add_product(t126, t123).add_product(t135, t132);
    let t142 = t141 * t140;
    let t143 = (-(t117 * t32)).add_product(t128, t123).add_product(t137, t132);
    let t144 = t143 * t140;
    let t145 = (-(t119 * t32)).add_product(t130, t123).add_product(t139, t132);
    let t146 = t145 * t140;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t22, t14)
        + c.inverse_bobbin_mass).add_product(t66, t65).add_product(t79, t78)).add_product(t93, t92)
        .sub_product(t104, t103).sub_product(t115, t114).sub_product(t126, t125).add_product(t135,
        t134).sub_product(t142, t141);
    let t148 = (t23 * t14).add_product(t68, t65).add_product(t82, t78).add_product(t95, t92)
        .sub_product(t106, t103).sub_product(t117, t114).sub_product(t128, t125).add_product(t137,
        t134).sub_product(t144, t141);
    let t149 = t148 * t147;
    let t150 = t33 * t147;
    let t151 = (t70 * t65).add_product(t84, t78).add_product(t97, t92).sub_product(t108, t103)
        .sub_product(t119, t114).sub_product(t130, t125).add_product(t139, t134).sub_product(t146,
        t141);
    let t152 = t151 * t147;
    let t153 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t23, t16)
        + c.inverse_bobbin_mass).add_product(t68, t67).add_product(t82, t81)).add_product(t95, t94)
        .sub_product(t106, t105).sub_product(t117, t116).sub_product(t128, t127).add_product(t137,
        t136).sub_product(t144, t143).sub_product(t149, t148);
    let t154 = (-t34).add_product(t150, t148);
    let t155 = t154 * t153;
    let t156 = (-(t70 * t67).add_product(t84, t81)).add_product(t97, t94).sub_product(t108, t105)
        .sub_product(t119, t116).sub_product(t130, t127).add_product(t139, t136).sub_product(t146,
        t143).sub_product(t152, t148);
    let t157 = t156 * t153;
    let t158 = t35 * bobbin_x_minus_drum_x_over_between;
    let t159 = t36 * bobbin_y_minus_drum_y_over_between;
    let t160 = R::literal(1.0) / (t158 - ((t33 * bobbin_x_minus_drum_x_over_between)
        .add_product(t34, bobbin_y_minus_drum_y_over_between) + t158 + t159).add_product(t150, t33)
        .add_product(t155, t154) + t159);
    let t161 = (t152 * t33).sub_product(t157, t154);
    let t162 = t161 * t160;
    let t163 = R::literal(1.0) / (-(t19 * t13)).add_product(t45, t44).sub_product(t55, t54)
        .sub_product(t70, t69).sub_product(t84, t83).add_product(t97, t96).sub_product(t108, t107)
        .sub_product(t119, t118).sub_product(t130, t129).add_product(t139, t138).sub_product(t146,
        t145).sub_product(t152, t151).sub_product(t157, t156).sub_product(t162, t161);
    let t164 = R::literal(50.0) * slide_rate;
    let t165 = t164 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t166 = p.spring_stiffness * slide_minus_spring_free_length;
    let t167 = t166 * cos_cylinder_phi;
    let t168 = t165 + t167;
    let t169 = t166 * sin_cylinder_phi;
    let t170 = t164 * sin_cylinder_phi;
    let t171 = t170 - (R::literal(2.943) - t169);
    let t172 = (t166 * t12).add_product(t164, t12);
    let t173 = t170 + (R::literal(1.962) + t169);
    let t174 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t175 = p.winding_force * bobbin_x_minus_drum_x;
    let t176 = t175 / between - c.t0;
    let post_omega_squared = post_omega * post_omega;
    let t177 = R::literal(0.1) * post_omega_squared;
    let t178 = t177 * cos_post_phi;
    let t179 = t177 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t180 = R::literal(0.06) * plate_omega_squared;
    let t181 = t180 * cos_plate_phi;
    let t182 = t180 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t183 = cylinder_omega_squared * cos_cylinder_phi;
    let t184 = cylinder_omega_squared * sin_cylinder_phi;
    let t185 = R::literal(2.0) * cylinder_v_x;
    let t186 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t187 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t188 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t189 = R::literal(2.0) * rod_v_x;
    let t190 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t191 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t192 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t193 = R::literal(0.06) * (rod_omega * rod_omega);
    let t194 = t193 * cos_rod_phi;
    let t195 = t193 * sin_rod_phi;
    let t196 = t16 * plate_omega_squared;
    let t197 = t14 * plate_omega_squared;
    let between_squared = between * between;
    let between_squared_times_between = between_squared * between;
    let t198 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t199 = bobbin_v_y * bobbin_x_minus_drum_x;
    let t200 = t199 * bobbin_y_minus_drum_y / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t201 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let drum_v_y_times_bobbin_x_minus_drum_x = drum_v_y * bobbin_x_minus_drum_x;
    let t202 = drum_v_y_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t203 = bobbin_v_x * bobbin_x_minus_drum_x;
    let t204 = t203 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t205 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let drum_v_x_times_bobbin_x_minus_drum_x = drum_v_x * bobbin_x_minus_drum_x;
    let t206 = drum_v_x_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t207 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t208 = (bobbin_v_x * (bobbin_v_x_over_between + t201 + t202 - t198 - t200
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t206 + t207
        - t204 - t205 - drum_v_y_over_between).add_product(drum_v_x, t198 + t200
        + drum_v_x_over_between - bobbin_v_x_over_between - t201 - t202).add_product(drum_v_y, t204
        + t205 + drum_v_y_over_between - bobbin_v_y_over_between - t206 - t207);
    let t209 = (R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi);
    let t210 = t41 * t178;
    let t211 = R::literal(9.81) - t179 - t210;
    let t212 = t20 * c.bobbin_radius_times_winding_force;
    let t213 = (t212 - (t181 + t178)).sub_product(t43, t178).sub_product(t51, t211);
    let t214 = t21 * c.bobbin_radius_times_winding_force;
    let t215 = (R::literal(9.81) - (t182 + t179 + R::literal(9.81)) - t214 - t210).sub_product(t53,
        t211).sub_product(t60, t213);
    let t216 = R::literal(3.333_333_333_333_333_5) * t168;
    let t217 = (t212.sub_product(R::literal(0.06), t183.add_product(plate_omega_squared,
        cos_plate_phi)) - t216).add_product(t26, t172).sub_product(t62, t213).sub_product(t74,
        t215);
    let t218 = R::literal(3.333_333_333_333_333_5) * t171;
    let t219 = (-(R::literal(9.81).add_product(R::literal(0.06), t184
        .add_product(plate_omega_squared, sin_plate_phi)) + t214 + t218).add_product(t27, t172)
        .add_product(t63, t213).add_product(t76, t215)).add_product(t87, t217);
    let t220 = (R::literal(-2_777.777_777_777_778) * t172).sub_product(t89, t217).sub_product(t100,
        t219);
    let t221 = (cylinder_omega * (((t189 * cos_cylinder_phi).add_product(t190, sin_cylinder_phi)
        + t191 + t192).sub_product(t185, cos_cylinder_phi).sub_product(t186, sin_cylinder_phi)
        - t187 - t188)).sub_product(t24, t168).add_product(t25, t171).sub_product(t28, t172)
        .sub_product(t29, t168).add_product(t30, t173).add_product(t91, t217).sub_product(t102,
        t219).add_product(t111, t220);
    let t222 = R::literal(5.0) * t168;
    let t223 = (t194 + t222).sub_product(t112, t220).sub_product(t122, t221);
    let t224 = R::literal(5.0) * t173;
    let t225 = (t195 + t224).add_product(t113, t220).add_product(t124, t221).add_product(t133,
        t223);
    let t226 = c.inverse_bobbin_mass * t174;
    let t227 = (t196.sub_product(t22, c.bobbin_radius_times_winding_force) + t226).sub_product(t66,
        t213).add_product(t79, t215).add_product(t93, t217).sub_product(t104, t219)
        .add_product(t115, t220).sub_product(t126, t221).add_product(t135, t223).sub_product(t142,
        t225);
    let t228 = c.inverse_bobbin_mass * t176;
    let t229 = ((t197 - R::literal(9.81)).add_product(t23, c.bobbin_radius_times_winding_force)
        - t228).add_product(t68, t213).sub_product(t82, t215).add_product(t95, t217)
        .sub_product(t106, t219).add_product(t117, t220).sub_product(t128, t221).add_product(t137,
        t223).sub_product(t144, t225).sub_product(t149, t227);
    let t230 = (-t208).add_product(t33, t174).sub_product(t34, t176)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t150, t227).sub_product(t155, t229)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t231 = (-(t209 * post_omega_squared)).add_product(t45, t178).sub_product(t55, t211)
        .add_product(t70, t213).sub_product(t84, t215).add_product(t97, t217).sub_product(t108,
        t219).add_product(t119, t220).sub_product(t130, t221).add_product(t139, t223)
        .sub_product(t146, t225).sub_product(t152, t227).sub_product(t157, t229).sub_product(t162,
        t230) * t163;
    let t232 = (t230 * t160).sub_product(t162, t231);
    let t233 = (t229 * t153).sub_product(t155, t232).sub_product(t157, t231);
    let t234 = (t227 * t147).sub_product(t149, t233).add_product(t150, t232).sub_product(t152,
        t231);
    let t235 = (t225 * t140).sub_product(t142, t234).sub_product(t144, t233).sub_product(t146,
        t231);
    let t236 = (-(t223 * t131)).add_product(t133, t235).add_product(t135, t234).add_product(t137,
        t233).add_product(t139, t231);
    let t237 = (t221 * t120).sub_product(t122, t236).add_product(t124, t235).sub_product(t126, t234)
        .sub_product(t128, t233).sub_product(t130, t231);
    let t238 = (t220 * t109).add_product(t111, t237).sub_product(t112, t236).add_product(t113, t235)
        .add_product(t115, t234).add_product(t117, t233).add_product(t119, t231);
    let t239 = (t219 * t98).sub_product(t100, t238).sub_product(t102, t237).sub_product(t104, t234)
        .sub_product(t106, t233).sub_product(t108, t231);
    let t240 = (-(t217 * t85)).add_product(t87, t239).sub_product(t89, t238).add_product(t91, t237)
        .add_product(t93, t234).add_product(t95, t233).add_product(t97, t231);
    let t241 = (t215 * t72).sub_product(t74, t240).sub_product(t76, t239).add_product(t79, t234)
        .sub_product(t82, t233).sub_product(t84, t231);
    let t242 = (t213 * t57).sub_product(t60, t241).sub_product(t62, t240).sub_product(t63, t239)
        .sub_product(t66, t234).add_product(t68, t233).add_product(t70, t231);
    let t243 = (t211 * t49).sub_product(t51, t242).sub_product(t53, t241).sub_product(t55, t231);
    let t244 = (t178 * t39).add_product(t41, t243).add_product(t43, t242).add_product(t41, t241)
        .sub_product(t45, t231);
    let drum_v_y_dot = (-R::literal(9.809_999_999_999_999)
        .add_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t232))).add_product(t36, t232);
    let drum_v_x_dot = (t35 * t232).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t232);
    let bobbin_v_y_dot = t228.sub_product(c.inverse_bobbin_mass, t233).sub_product(t34, t232);
    let t245 = t226.add_product(c.inverse_bobbin_mass, t234).add_product(t33, t232);
    let rod_omega_dot = (t31 * t236).sub_product(R::literal(4_166.666_666_666_667), t238)
        .sub_product(t32, t235);
    let rod_v_x_dot = (-t222).add_product(t29, t237).sub_product(R::literal(5.0), t236);
    let cylinder_omega_dot = (-(t172 * R::literal(2_777.777_777_777_778)).add_product(t26, t240))
        .add_product(t27, t239).sub_product(R::literal(-2_777.777_777_777_778), t238)
        .add_product(t28, t237);
    let cylinder_v_y_dot = t218.sub_product(R::literal(3.333_333_333_333_333_5), t239)
        .add_product(t25, t237);
    let cylinder_v_x_dot = t216.sub_product(R::literal(3.333_333_333_333_333_5), t240)
        .sub_product(t24, t237);
    let plate_omega_dot = (-c.t1.add_product(t20, t242)).add_product(t21, t241).sub_product(t20,
        t240).add_product(t21, t239).add_product(t22, t234).sub_product(t23, t233);
    let post_omega_dot = (t18 * t243).sub_product(t17, t244).sub_product(t17, t242)
        .add_product(t18, t241).sub_product(t19, t231);
    let t246 = (t1 * t243).add_product(t0, t244).add_product(t0, t242).add_product(t1, t241)
        .add_product(t209, t231);
    let t247 = t179.sub_product(t0, post_omega_dot).add_product(t17, t246);
    let t248 = (-t178.add_product(t1, post_omega_dot).add_product(t18, t246)).add_product(t41,
        t247);
    let t249 = t247.add_product(t43, t247).sub_product(t51, t248);
    let t250 = t248.sub_product(t53, t248).sub_product(t60, t249);
    let t251 = (t62 * t249).add_product(t74, t250);
    let t252 = (t63 * t249).add_product(t76, t250).add_product(t87, t251);
    let t253 = (t89 * t251).add_product(t100, t252);
    let t254 = (-(t91 * t251)).add_product(t102, t252).add_product(t111, t253);
    let t255 = (t112 * t253).add_product(t122, t254);
    let t256 = (t113 * t253).add_product(t124, t254).sub_product(t133, t255);
    let t257 = (-(t66 * t249)).add_product(t79, t250).sub_product(t93, t251).add_product(t104, t252)
        .add_product(t115, t253).sub_product(t126, t254).sub_product(t135, t255).sub_product(t142,
        t256);
    let t258 = (t68 * t249).sub_product(t82, t250).sub_product(t95, t251).add_product(t106, t252)
        .add_product(t117, t253).sub_product(t128, t254).sub_product(t137, t255).sub_product(t144,
        t256).sub_product(t149, t257);
    let t259 = (t150 * t257).sub_product(t155, t258);
    let t260 = (t13 * post_omega_squared).sub_product(t209, post_omega_dot).add_product(t19, t246)
        .sub_product(t45, t247).sub_product(t55, t248).add_product(t70, t249).sub_product(t84, t250)
        .sub_product(t97, t251).add_product(t108, t252).add_product(t119, t253).sub_product(t130,
        t254).sub_product(t139, t255).sub_product(t146, t256).sub_product(t152, t257)
        .sub_product(t157, t258).sub_product(t162, t259) * t163;
    let t261 = (t259 * t160).sub_product(t162, t260);
    let t262 = (t258 * t153).sub_product(t155, t261).sub_product(t157, t260);
    let t263 = (t257 * t147).sub_product(t149, t262).add_product(t150, t261).sub_product(t152,
        t260);
    let t264 = (t256 * t140).sub_product(t142, t263).sub_product(t144, t262).sub_product(t146,
        t260);
    let t265 = (t255 * t131).add_product(t133, t264).add_product(t135, t263).add_product(t137, t262)
        .add_product(t139, t260);
    let t266 = (t254 * t120).sub_product(t122, t265).add_product(t124, t264).sub_product(t126, t263)
        .sub_product(t128, t262).sub_product(t130, t260);
    let t267 = (t253 * t109).add_product(t111, t266).sub_product(t112, t265).add_product(t113, t264)
        .add_product(t115, t263).add_product(t117, t262).add_product(t119, t260);
    let t268 = (t252 * t98).add_product(t100, t267).add_product(t102, t266).add_product(t104, t263)
        .add_product(t106, t262).add_product(t108, t260);
    let t269 = (t251 * t85).sub_product(t87, t268).sub_product(t89, t267).add_product(t91, t266)
        .add_product(t93, t263).add_product(t95, t262).add_product(t97, t260);
    let t270 = (t250 * t72).sub_product(t74, t269).add_product(t76, t268).add_product(t79, t263)
        .sub_product(t82, t262).sub_product(t84, t260);
    let t271 = (t249 * t57).sub_product(t60, t270).sub_product(t62, t269).add_product(t63, t268)
        .sub_product(t66, t263).add_product(t68, t262).add_product(t70, t260);
    let t272 = (t248 * t49).sub_product(t51, t271).sub_product(t53, t270).sub_product(t55, t260);
    let t273 = (-(t247 * t39)).add_product(t41, t272).add_product(t43, t271).add_product(t41, t270)
        .sub_product(t45, t260);
    let drum_v_y_dot_by_post_phi = (t36 * t261).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t261);
    let drum_v_x_dot_by_post_phi = (t35 * t261).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t261);
    let bobbin_v_y_dot_by_post_phi = -(t34 * t261).add_product(c.inverse_bobbin_mass, t262);
    let bobbin_v_x_dot_by_post_phi = -(t33 * t261).add_product(c.inverse_bobbin_mass, t263);
    let rod_omega_dot_by_post_phi = (t31 * t265).sub_product(R::literal(4_166.666_666_666_667),
        t267).sub_product(t32, t264);
    let rod_v_y_dot_by_post_phi = (R::literal(-5.0) * t264).sub_product(t30, t266);
    let rod_v_x_dot_by_post_phi = (R::literal(-5.0) * t265).add_product(t29, t266);
    let cylinder_omega_dot_by_post_phi = (-(t27 * t268).add_product(t26, t269)
        .add_product(R::literal(-2_777.777_777_777_778), t267)).add_product(t28, t266);
    let cylinder_v_y_dot_by_post_phi = (t25 * t266)
        .add_product(R::literal(3.333_333_333_333_333_5), t268);
    let cylinder_v_x_dot_by_post_phi = (-(t24 * t266))
        .add_product(R::literal(-3.333_333_333_333_333_5), t269);
    let plate_omega_dot_by_post_phi = (t21 * t270).sub_product(t20, t271).sub_product(t20, t269)
        .sub_product(t21, t268).add_product(t22, t263).sub_product(t23, t262);
    let plate_v_y_dot_by_post_phi = (R::literal(-0.833_333_333_333_333_4) * t268)
        .sub_product(R::literal(0.833_333_333_333_333_4), t270)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t262);
    let plate_v_x_dot_by_post_phi = (R::literal(0.833_333_333_333_333_4) * t269)
        .add_product(R::literal(-0.833_333_333_333_333_4), t271)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t263);
    let post_omega_dot_by_post_phi = (-(t246 * R::literal(370.370_370_370_370_3)).add_product(t17,
        t273)).add_product(t18, t272).sub_product(t17, t271).add_product(t18, t270)
        .sub_product(t19, t260);
    let post_v_y_dot_by_post_phi = (R::literal(1.25) * t270).add_product(R::literal(-1.25), t272);
    let post_v_x_dot_by_post_phi = (R::literal(1.25) * t271).add_product(R::literal(-1.25), t273);
    let t274 = (-(t3 * t241).add_product(t2, t242).add_product(t2, t240).add_product(t3, t239)
        .add_product(t15, t234)).add_product(t14, t233);
    let t275 = t182.sub_product(t2, plate_omega_dot).sub_product(t20, t274);
    let t276 = (-t181.add_product(t3, plate_omega_dot)).add_product(t21, t274);
    let t277 = t276.sub_product(t60, t275);
    let t278 = t275.sub_product(t62, t275).sub_product(t74, t277);
    let t279 = t276.sub_product(t63, t275).sub_product(t76, t277).add_product(t87, t278);
    let t280 = (t89 * t278).add_product(t100, t279);
    let t281 = (t91 * t278).sub_product(t102, t279).sub_product(t111, t280);
    let t282 = (t112 * t280).sub_product(t122, t281);
    let t283 = (-(t113 * t280)).add_product(t124, t281).add_product(t133, t282);
    let t284 = (-t197.add_product(t15, plate_omega_dot)).add_product(t22, t274).sub_product(t66,
        t275).add_product(t79, t277).add_product(t93, t278).sub_product(t104, t279)
        .sub_product(t115, t280).sub_product(t126, t281).add_product(t135, t282).sub_product(t142,
        t283);
    let t285 = t196.add_product(t14, plate_omega_dot).sub_product(t23, t274).add_product(t68, t275)
        .sub_product(t82, t277).add_product(t95, t278).sub_product(t106, t279).sub_product(t117,
        t280).sub_product(t128, t281).add_product(t137, t282).sub_product(t144, t283)
        .sub_product(t149, t284);
    let t286 = (t150 * t284).sub_product(t155, t285);
    let t287 = (t70 * t275).sub_product(t84, t277).add_product(t97, t278).sub_product(t108, t279)
        .sub_product(t119, t280).sub_product(t130, t281).add_product(t139, t282).sub_product(t146,
        t283).sub_product(t152, t284).sub_product(t157, t285).sub_product(t162, t286) * t163;
    let t288 = (t286 * t160).sub_product(t162, t287);
    let t289 = (t285 * t153).sub_product(t155, t288).sub_product(t157, t287);
    let t290 = (t284 * t147).sub_product(t149, t289).add_product(t150, t288).sub_product(t152,
        t287);
    let t291 = (t283 * t140).sub_product(t142, t290).sub_product(t144, t289).sub_product(t146,
        t287);
    let t292 = (-(t282 * t131)).add_product(t133, t291).add_product(t135, t290).add_product(t137,
        t289).add_product(t139, t287);
    let t293 = (t281 * t120).sub_product(t122, t292).add_product(t124, t291).sub_product(t126, t290)
        .sub_product(t128, t289).sub_product(t130, t287);
    let t294 = (-(t280 * t109)).add_product(t111, t293).sub_product(t112, t292).add_product(t113,
        t291).add_product(t115, t290).add_product(t117, t289).add_product(t119, t287);
    let t295 = (t279 * t98).sub_product(t100, t294).sub_product(t102, t293).sub_product(t104, t290)
        .sub_product(t106, t289).sub_product(t108, t287);
    let t296 = (-(t278 * t85)).add_product(t87, t295).sub_product(t89, t294).add_product(t91, t293)
        .add_product(t93, t290).add_product(t95, t289).add_product(t97, t287);
    let t297 = (t277 * t72).sub_product(t74, t296).sub_product(t76, t295).add_product(t79, t290)
        .sub_product(t82, t289).sub_product(t84, t287);
    let t298 = (t275 * t57).sub_product(t60, t297).sub_product(t62, t296).sub_product(t63, t295)
        .sub_product(t66, t290).add_product(t68, t289).add_product(t70, t287);
    let t299 = (t53 * t297).add_product(t51, t298).add_product(t55, t287);
    let t300 = (t43 * t298).sub_product(t41, t299).add_product(t41, t297).sub_product(t45, t287);
    let drum_v_y_dot_by_plate_phi = (t36 * t288).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t288);
    let drum_v_x_dot_by_plate_phi = (t35 * t288).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t288);
    let bobbin_v_y_dot_by_plate_phi = -(t34 * t288).add_product(c.inverse_bobbin_mass, t289);
    let bobbin_v_x_dot_by_plate_phi = -(t33 * t288).add_product(c.inverse_bobbin_mass, t290);
    let rod_omega_dot_by_plate_phi = (t31 * t292).sub_product(R::literal(4_166.666_666_666_667),
        t294).sub_product(t32, t291);
    let rod_v_y_dot_by_plate_phi = (R::literal(-5.0) * t291).sub_product(t30, t293);
    let rod_v_x_dot_by_plate_phi = (R::literal(-5.0) * t292).add_product(t29, t293);
    let cylinder_omega_dot_by_plate_phi = (t27 * t295).sub_product(t26, t296)
        .sub_product(R::literal(-2_777.777_777_777_778), t294).add_product(t28, t293);
    let cylinder_v_y_dot_by_plate_phi = (t25 * t293)
        .sub_product(R::literal(3.333_333_333_333_333_5), t295);
    let cylinder_v_x_dot_by_plate_phi = (-(t24 * t293))
        .add_product(R::literal(-3.333_333_333_333_333_5), t296);
    let plate_omega_dot_by_plate_phi = (t274 * R::literal(400.0)).sub_product(t20, t298)
        .add_product(t21, t297).sub_product(t20, t296).add_product(t21, t295).add_product(t22, t290)
        .sub_product(t23, t289);
    let plate_v_y_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t295)
        .add_product(R::literal(-0.833_333_333_333_333_4), t297)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t289);
    let plate_v_x_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t296)
        .add_product(R::literal(-0.833_333_333_333_333_4), t298)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t290);
    let post_omega_dot_by_plate_phi = (-(t18 * t299).add_product(t17, t300).add_product(t17, t298))
        .add_product(t18, t297).sub_product(t19, t287);
    let post_v_y_dot_by_plate_phi = (R::literal(1.25) * t297).add_product(R::literal(1.25), t299);
    let post_v_x_dot_by_plate_phi = (R::literal(1.25) * t298).add_product(R::literal(-1.25), t300);
    let t301 = p.spring_stiffness * cos_cylinder_phi;
    let t302 = R::literal(50.0) * cylinder_omega;
    let t303 = t302 * sin_cylinder_phi;
    let t304 = t303 - t301;
    let t305 = t304 * cos_cylinder_phi;
    let t306 = t304 * sin_cylinder_phi;
    let t307 = t302 * t12;
    let t308 = t307 * sin_cylinder_phi;
    let t309 = p.spring_stiffness * t12;
    let t310 = t309 * cos_cylinder_phi;
    let t311 = t301 - t303;
    let t312 = t311 * cos_cylinder_phi;
    let t313 = t311 * sin_cylinder_phi;
    let t314 = cos_cylinder_phi * t237;
    let t315 = t310 - t308 - t170 - t169 - t314;
    let t316 = cos_cylinder_phi * cylinder_omega_dot;
    let t317 = R::literal(3.333_333_333_333_333_5) * t305;
    let t318 = t317.add_product(t26, t315);
    let t319 = R::literal(3.333_333_333_333_333_5) * t306;
    let t320 = (-t319).add_product(t27, t315).sub_product(t87, t318);
    let t321 = (R::literal(2_777.777_777_777_778) * t315).add_product(t89, t318).sub_product(t100,
        t320);
    let t322 = (t184 - t316).sub_product(t24, t305).add_product(t25, t306).add_product(t28, t315)
        .add_product(t29, t312).sub_product(t30, t313).sub_product(t91, t318).sub_product(t102,
        t320).add_product(t111, t321);
    let t323 = R::literal(5.0) * t312;
    let t324 = t323.add_product(t112, t321).add_product(t122, t322);
    let t325 = R::literal(5.0) * t313;
    let t326 = (-t325).add_product(t113, t321).add_product(t124, t322).sub_product(t133, t324);
    let t327 = (-(t93 * t318).add_product(t104, t320)).add_product(t115, t321).sub_product(t126,
        t322).sub_product(t135, t324).sub_product(t142, t326);
    let t328 = (-(t95 * t318).add_product(t106, t320)).add_product(t117, t321).sub_product(t128,
        t322).sub_product(t137, t324).sub_product(t144, t326).sub_product(t149, t327);
    let t329 = (t150 * t327).sub_product(t155, t328);
    let t330 = (-(t97 * t318).add_product(t108, t320)).add_product(t119, t321).sub_product(t130,
        t322).sub_product(t139, t324).sub_product(t146, t326).sub_product(t152, t327)
        .sub_product(t157, t328).sub_product(t162, t329) * t163;
    let t331 = (t329 * t160).sub_product(t162, t330);
    let t332 = (t328 * t153).sub_product(t155, t331).sub_product(t157, t330);
    let t333 = (t327 * t147).sub_product(t149, t332).add_product(t150, t331).sub_product(t152,
        t330);
    let t334 = (t326 * t140).sub_product(t142, t333).sub_product(t144, t332).sub_product(t146,
        t330);
    let t335 = (t324 * t131).add_product(t133, t334).add_product(t135, t333).add_product(t137, t332)
        .add_product(t139, t330);
    let t336 = (t322 * t120).sub_product(t122, t335).add_product(t124, t334).sub_product(t126, t333)
        .sub_product(t128, t332).sub_product(t130, t330);
    let t337 = (t321 * t109).add_product(t111, t336).sub_product(t112, t335).add_product(t113, t334)
        .add_product(t115, t333).add_product(t117, t332).add_product(t119, t330);
    let t338 = (t320 * t98).sub_product(t100, t337).sub_product(t102, t336).sub_product(t104, t333)
        .sub_product(t106, t332).sub_product(t108, t330);
    let t339 = (t318 * t85).add_product(t87, t338).sub_product(t89, t337).add_product(t91, t336)
        .add_product(t93, t333).add_product(t95, t332).add_product(t97, t330);
    let t340 = (-(t76 * t338).add_product(t74, t339)).add_product(t79, t333).sub_product(t82, t332)
        .sub_product(t84, t330);
    let t341 = (-(t62 * t339).add_product(t60, t340).add_product(t63, t338).add_product(t66, t333))
        .add_product(t68, t332).add_product(t70, t330);
    let t342 = (t53 * t340).add_product(t51, t341).add_product(t55, t330);
    let t343 = (t43 * t341).sub_product(t41, t342).add_product(t41, t340).sub_product(t45, t330);
    let drum_v_y_dot_by_cylinder_x = (t36 * t331).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t331);
    let drum_v_x_dot_by_cylinder_x = (t35 * t331).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t331);
    let bobbin_v_y_dot_by_cylinder_x = -(t34 * t331).add_product(c.inverse_bobbin_mass, t332);
    let bobbin_v_x_dot_by_cylinder_x = -(t33 * t331).add_product(c.inverse_bobbin_mass, t333);
    let rod_omega_dot_by_cylinder_x = (t31 * t335).sub_product(R::literal(4_166.666_666_666_667),
        t337).sub_product(t32, t334);
    let rod_v_y_dot_by_cylinder_x = t325.sub_product(t30, t336).sub_product(R::literal(5.0), t334);
    let rod_v_x_dot_by_cylinder_x = t323.add_product(t29, t336).sub_product(R::literal(5.0), t335);
    let cylinder_omega_dot_by_cylinder_x = (t315 * R::literal(2_777.777_777_777_778))
        .sub_product(t26, t339).add_product(t27, t338)
        .sub_product(R::literal(-2_777.777_777_777_778), t337).add_product(t28, t336);
    let cylinder_v_y_dot_by_cylinder_x = t319.sub_product(R::literal(3.333_333_333_333_333_5), t338)
        .add_product(t25, t336);
    let cylinder_v_x_dot_by_cylinder_x = t317.sub_product(R::literal(3.333_333_333_333_333_5), t339)
        .sub_product(t24, t336);
    let plate_omega_dot_by_cylinder_x = (t21 * t340).sub_product(t20, t341).sub_product(t20, t339)
        .add_product(t21, t338).add_product(t22, t333).sub_product(t23, t332);
    let plate_v_y_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t338)
        .add_product(R::literal(-0.833_333_333_333_333_4), t340)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t332);
    let plate_v_x_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t339)
        .add_product(R::literal(-0.833_333_333_333_333_4), t341)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t333);
    let post_omega_dot_by_cylinder_x = (-(t18 * t342).add_product(t17, t343).add_product(t17, t341))
        .add_product(t18, t340).sub_product(t19, t330);
    let post_v_y_dot_by_cylinder_x = (R::literal(1.25) * t340).add_product(R::literal(1.25), t342);
    let post_v_x_dot_by_cylinder_x = (R::literal(1.25) * t341).add_product(R::literal(-1.25), t343);
    let t344 = (t302 * cos_cylinder_phi).add_product(p.spring_stiffness, sin_cylinder_phi);
    let t345 = t344 * cos_cylinder_phi;
    let t346 = t344 * sin_cylinder_phi;
    let t347 = t309 * sin_cylinder_phi;
    let t348 = t165.add_product(t307, cos_cylinder_phi) + t167 + t347;
    let t349 = sin_cylinder_phi * t237;
    let t350 = t348 - t349;
    let t351 = t183.add_product(sin_cylinder_phi, cylinder_omega_dot);
    let t352 = R::literal(3.333_333_333_333_333_5) * t345;
    let t353 = t352.sub_product(t26, t350);
    let t354 = R::literal(3.333_333_333_333_333_5) * t346;
    let t355 = t354.add_product(t27, t350).add_product(t87, t353);
    let t356 = (R::literal(-2_777.777_777_777_778) * t350).add_product(t89, t353).add_product(t100,
        t355);
    let t357 = t24 * t345;
    let t358 = t25 * t346;
    let t359 = t29 * t345;
    let t360 = t30 * t346;
    let t361 = ((t357 - t351 - t358).add_product(t28, t350) + t359 - t360).add_product(t91, t353)
        .sub_product(t102, t355).sub_product(t111, t356);
    let t362 = R::literal(5.0) * t345;
    let t363 = (-t362).add_product(t112, t356).sub_product(t122, t361);
    let t364 = R::literal(5.0) * t346;
    let t365 = (-t364.add_product(t113, t356)).add_product(t124, t361).add_product(t133, t363);
    let t366 = (t93 * t353).sub_product(t104, t355).sub_product(t115, t356).sub_product(t126, t361)
        .add_product(t135, t363).sub_product(t142, t365);
    let t367 = (t95 * t353).sub_product(t106, t355).sub_product(t117, t356).sub_product(t128, t361)
        .add_product(t137, t363).sub_product(t144, t365).sub_product(t149, t366);
    let t368 = (t150 * t366).sub_product(t155, t367);
    let t369 = (t97 * t353).sub_product(t108, t355).sub_product(t119, t356).sub_product(t130, t361)
        .add_product(t139, t363).sub_product(t146, t365).sub_product(t152, t366).sub_product(t157,
        t367).sub_product(t162, t368) * t163;
    let t370 = (t368 * t160).sub_product(t162, t369);
    let t371 = (t367 * t153).sub_product(t155, t370).sub_product(t157, t369);
    let t372 = (t366 * t147).sub_product(t149, t371).add_product(t150, t370).sub_product(t152,
        t369);
    let t373 = (t365 * t140).sub_product(t142, t372).sub_product(t144, t371).sub_product(t146,
        t369);
    let t374 = (-(t363 * t131)).add_product(t133, t373).add_product(t135, t372).add_product(t137,
        t371).add_product(t139, t369);
    let t375 = (t361 * t120).sub_product(t122, t374).add_product(t124, t373).sub_product(t126, t372)
        .sub_product(t128, t371).sub_product(t130, t369);
    let t376 = (-(t356 * t109)).add_product(t111, t375).sub_product(t112, t374).add_product(t113,
        t373).add_product(t115, t372).add_product(t117, t371).add_product(t119, t369);
    let t377 = (t355 * t98).sub_product(t100, t376).sub_product(t102, t375).sub_product(t104, t372)
        .sub_product(t106, t371).sub_product(t108, t369);
    let t378 = (-(t353 * t85)).add_product(t87, t377).sub_product(t89, t376).add_product(t91, t375)
        .add_product(t93, t372).add_product(t95, t371).add_product(t97, t369);
    let t379 = (-(t76 * t377).add_product(t74, t378)).add_product(t79, t372).sub_product(t82, t371)
        .sub_product(t84, t369);
    let t380 = (-(t62 * t378).add_product(t60, t379).add_product(t63, t377).add_product(t66, t372))
        .add_product(t68, t371).add_product(t70, t369);
    let t381 = (t53 * t379).add_product(t51, t380).add_product(t55, t369);
    let t382 = (t43 * t380).sub_product(t41, t381).add_product(t41, t379).sub_product(t45, t369);
    let drum_v_y_dot_by_cylinder_y = (t36 * t370).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t370);
    let drum_v_x_dot_by_cylinder_y = (t35 * t370).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t370);
    let bobbin_v_y_dot_by_cylinder_y = -(t34 * t370).add_product(c.inverse_bobbin_mass, t371);
    let bobbin_v_x_dot_by_cylinder_y = -(t33 * t370).add_product(c.inverse_bobbin_mass, t372);
    let rod_omega_dot_by_cylinder_y = (t31 * t374).sub_product(R::literal(4_166.666_666_666_667),
        t376).sub_product(t32, t373);
    let rod_v_y_dot_by_cylinder_y = t364.sub_product(t30, t375).sub_product(R::literal(5.0), t373);
    let rod_v_x_dot_by_cylinder_y = t362.add_product(t29, t375).sub_product(R::literal(5.0), t374);
    let cylinder_omega_dot_by_cylinder_y = (t350 * R::literal(2_777.777_777_777_778))
        .sub_product(t26, t378).add_product(t27, t377)
        .sub_product(R::literal(-2_777.777_777_777_778), t376).add_product(t28, t375);
    let cylinder_v_y_dot_by_cylinder_y = (-t354.add_product(R::literal(3.333_333_333_333_333_5),
        t377)).add_product(t25, t375);
    let cylinder_v_x_dot_by_cylinder_y = (-t352).add_product(R::literal(-3.333_333_333_333_333_5),
        t378).sub_product(t24, t375);
    let plate_omega_dot_by_cylinder_y = (t21 * t379).sub_product(t20, t380).sub_product(t20, t378)
        .add_product(t21, t377).add_product(t22, t372).sub_product(t23, t371);
    let plate_v_y_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t377)
        .add_product(R::literal(-0.833_333_333_333_333_4), t379)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t371);
    let plate_v_x_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t378)
        .add_product(R::literal(-0.833_333_333_333_333_4), t380)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t372);
    let post_omega_dot_by_cylinder_y = (-(t18 * t381).add_product(t17, t382).add_product(t17, t380))
        .add_product(t18, t379).sub_product(t19, t369);
    let post_v_y_dot_by_cylinder_y = (R::literal(1.25) * t379).add_product(R::literal(1.25), t381);
    let post_v_x_dot_by_cylinder_y = (R::literal(1.25) * t380).add_product(R::literal(-1.25), t382);
    let t383 = R::literal(50.0) * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
        .sub_product(cylinder_omega, slide).sub_product(rod_v_x_minus_cylinder_v_x,
        sin_cylinder_phi);
    let t384 = t383 * cos_cylinder_phi;
    let t385 = t165.add_product(t383, sin_cylinder_phi) + (t167 + t347);
    let t386 = t12 * t12;
    let t387 = R::literal(0.06) * cylinder_omega_squared;
    let t388 = t384 + t310 - t170 - t169 - t314;
    let t389 = t385 - t349;
    let t390 = t10 - t11;
    let t391 = (p.spring_stiffness * slide * slide_minus_spring_free_length)
        .add_product(R::literal(50.0) * slide, slide_rate).sub_product(t383, t12)
        .sub_product(p.spring_stiffness, t386).sub_product(t4, t240).sub_product(t5, t239)
        .sub_product(t390, t237);
    let t392 = t170 + t169 - t384 - t310 + t314;
    let t393 = t349 - t385;
    let t394 = R::literal(3.333_333_333_333_333_5) * t388;
    let t395 = ((t387 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t394)
        .sub_product(t26, t391);
    let t396 = R::literal(3.333_333_333_333_333_5) * t389;
    let t397 = (-((t387 * cos_cylinder_phi).add_product(t5, cylinder_omega_dot) + t396))
        .add_product(t27, t391).add_product(t87, t395);
    let t398 = (R::literal(-2_777.777_777_777_778) * t391).add_product(t89, t395).add_product(t100,
        t397);
    let t399 = (cylinder_omega * (t185 * sin_cylinder_phi).add_product(t190, cos_cylinder_phi)
        .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
        .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi).sub_product(t186,
        cos_cylinder_phi).sub_product(t189, sin_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi)).sub_product(cos_cylinder_phi,
        cylinder_v_x_dot).sub_product(sin_cylinder_phi, cylinder_v_y_dot).sub_product(t390,
        cylinder_omega_dot).add_product(cos_cylinder_phi, rod_v_x_dot)
        .sub_product(sin_cylinder_phi, t224.add_product(t30, t237).add_product(R::literal(5.0),
        t235)).sub_product(t24, t388).add_product(t25, t389).add_product(t28, t391)
        .add_product(t29, t392).sub_product(t30, t393).add_product(t91, t395).sub_product(t102,
        t397).sub_product(t111, t398);
    let t400 = R::literal(5.0) * t392;
    let t401 = (-t400).add_product(t112, t398).sub_product(t122, t399);
    let t402 = R::literal(5.0) * t393;
    let t403 = (-t402.add_product(t113, t398)).add_product(t124, t399).add_product(t133, t401);
    let t404 = (t93 * t395).sub_product(t104, t397).sub_product(t115, t398).sub_product(t126, t399)
        .add_product(t135, t401).sub_product(t142, t403);
    let t405 = (t95 * t395).sub_product(t106, t397).sub_product(t117, t398).sub_product(t128, t399)
        .add_product(t137, t401).sub_product(t144, t403).sub_product(t149, t404);
    let t406 = (t150 * t404).sub_product(t155, t405);
    let t407 = (t97 * t395).sub_product(t108, t397).sub_product(t119, t398).sub_product(t130, t399)
        .add_product(t139, t401).sub_product(t146, t403).sub_product(t152, t404).sub_product(t157,
        t405).sub_product(t162, t406) * t163;
    let t408 = (t406 * t160).sub_product(t162, t407);
    let t409 = (t405 * t153).sub_product(t155, t408).sub_product(t157, t407);
    let t410 = (t404 * t147).sub_product(t149, t409).add_product(t150, t408).sub_product(t152,
        t407);
    let t411 = (t403 * t140).sub_product(t142, t410).sub_product(t144, t409).sub_product(t146,
        t407);
    let t412 = (-(t401 * t131)).add_product(t133, t411).add_product(t135, t410).add_product(t137,
        t409).add_product(t139, t407);
    let t413 = (t399 * t120).sub_product(t122, t412).add_product(t124, t411).sub_product(t126, t410)
        .sub_product(t128, t409).sub_product(t130, t407);
    let t414 = (-(t398 * t109)).add_product(t111, t413).sub_product(t112, t412).add_product(t113,
        t411).add_product(t115, t410).add_product(t117, t409).add_product(t119, t407);
    let t415 = (t397 * t98).sub_product(t100, t414).sub_product(t102, t413).sub_product(t104, t410)
        .sub_product(t106, t409).sub_product(t108, t407);
    let t416 = (-(t395 * t85)).add_product(t87, t415).sub_product(t89, t414).add_product(t91, t413)
        .add_product(t93, t410).add_product(t95, t409).add_product(t97, t407);
    let t417 = (-(t76 * t415).add_product(t74, t416)).add_product(t79, t410).sub_product(t82, t409)
        .sub_product(t84, t407);
    let t418 = (-(t62 * t416).add_product(t60, t417).add_product(t63, t415).add_product(t66, t410))
        .add_product(t68, t409).add_product(t70, t407);
    let t419 = (t53 * t417).add_product(t51, t418).add_product(t55, t407);
    let t420 = (t43 * t418).sub_product(t41, t419).add_product(t41, t417).sub_product(t45, t407);
    let drum_v_y_dot_by_cylinder_phi = (t36 * t408)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t408);
    let drum_v_x_dot_by_cylinder_phi = (t35 * t408)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t408);
    let bobbin_v_y_dot_by_cylinder_phi = -(t34 * t408).add_product(c.inverse_bobbin_mass, t409);
    let bobbin_v_x_dot_by_cylinder_phi = -(t33 * t408).add_product(c.inverse_bobbin_mass, t410);
    let rod_omega_dot_by_cylinder_phi = (t31 * t412).sub_product(R::literal(4_166.666_666_666_667),
        t414).sub_product(t32, t411);
    let rod_v_y_dot_by_cylinder_phi = t402.sub_product(t30, t413).sub_product(R::literal(5.0),
        t411);
    let rod_v_x_dot_by_cylinder_phi = t400.add_product(t29, t413).sub_product(R::literal(5.0),
        t412);
    let cylinder_omega_dot_by_cylinder_phi = (t391 * R::literal(2_777.777_777_777_778))
        .sub_product(t26, t416).add_product(t27, t415)
        .sub_product(R::literal(-2_777.777_777_777_778), t414).add_product(t28, t413);
    let cylinder_v_y_dot_by_cylinder_phi = t396.sub_product(R::literal(3.333_333_333_333_333_5),
        t415).add_product(t25, t413);
    let cylinder_v_x_dot_by_cylinder_phi = t394.sub_product(R::literal(3.333_333_333_333_333_5),
        t416).sub_product(t24, t413);
    let plate_omega_dot_by_cylinder_phi = (t21 * t417).sub_product(t20, t418).sub_product(t20, t416)
        .add_product(t21, t415).add_product(t22, t410).sub_product(t23, t409);
    let plate_v_y_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t415)
        .add_product(R::literal(-0.833_333_333_333_333_4), t417)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t409);
    let plate_v_x_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t416)
        .add_product(R::literal(-0.833_333_333_333_333_4), t418)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t410);
    let post_omega_dot_by_cylinder_phi = (-(t18 * t419).add_product(t17, t420).add_product(t17,
        t418)).add_product(t18, t417).sub_product(t19, t407);
    let post_v_y_dot_by_cylinder_phi = (R::literal(1.25) * t417).add_product(R::literal(1.25),
        t419);
    let post_v_x_dot_by_cylinder_phi = (R::literal(1.25) * t418).add_product(R::literal(-1.25),
        t420);
    let t421 = t308 + t170 + t169 - t310 + t314;
    let t422 = R::literal(3.333_333_333_333_333_5) * t312;
    let t423 = t422.add_product(t26, t421);
    let t424 = R::literal(3.333_333_333_333_333_5) * t313;
    let t425 = (-t424).add_product(t27, t421).sub_product(t87, t423);
    let t426 = (R::literal(2_777.777_777_777_778) * t421).add_product(t89, t423).sub_product(t100,
        t425);
    let t427 = (t316 - t184).sub_product(t24, t312).add_product(t25, t313).add_product(t28, t421)
        .add_product(t29, t305).sub_product(t30, t306).sub_product(t91, t423).sub_product(t102,
        t425).add_product(t111, t426);
    let t428 = R::literal(5.0) * t305;
    let t429 = t428.add_product(t112, t426).add_product(t122, t427);
    let t430 = R::literal(5.0) * t306;
    let t431 = (-t430).add_product(t113, t426).add_product(t124, t427).sub_product(t133, t429);
    let t432 = (-(t93 * t423).add_product(t104, t425)).add_product(t115, t426).sub_product(t126,
        t427).sub_product(t135, t429).sub_product(t142, t431);
    let t433 = (-(t95 * t423).add_product(t106, t425)).add_product(t117, t426).sub_product(t128,
        t427).sub_product(t137, t429).sub_product(t144, t431).sub_product(t149, t432);
    let t434 = (t150 * t432).sub_product(t155, t433);
    let t435 = (-(t97 * t423).add_product(t108, t425)).add_product(t119, t426).sub_product(t130,
        t427).sub_product(t139, t429).sub_product(t146, t431).sub_product(t152, t432)
        .sub_product(t157, t433).sub_product(t162, t434) * t163;
    let t436 = (t434 * t160).sub_product(t162, t435);
    let t437 = (t433 * t153).sub_product(t155, t436).sub_product(t157, t435);
    let t438 = (t432 * t147).sub_product(t149, t437).add_product(t150, t436).sub_product(t152,
        t435);
    let t439 = (t431 * t140).sub_product(t142, t438).sub_product(t144, t437).sub_product(t146,
        t435);
    let t440 = (t429 * t131).add_product(t133, t439).add_product(t135, t438).add_product(t137, t437)
        .add_product(t139, t435);
    let t441 = (t427 * t120).sub_product(t122, t440).add_product(t124, t439).sub_product(t126, t438)
        .sub_product(t128, t437).sub_product(t130, t435);
    let t442 = (t426 * t109).add_product(t111, t441).sub_product(t112, t440).add_product(t113, t439)
        .add_product(t115, t438).add_product(t117, t437).add_product(t119, t435);
    let t443 = (t425 * t98).sub_product(t100, t442).sub_product(t102, t441).sub_product(t104, t438)
        .sub_product(t106, t437).sub_product(t108, t435);
    let t444 = (t423 * t85).add_product(t87, t443).sub_product(t89, t442).add_product(t91, t441)
        .add_product(t93, t438).add_product(t95, t437).add_product(t97, t435);
    let t445 = (-(t76 * t443).add_product(t74, t444)).add_product(t79, t438).sub_product(t82, t437)
        .sub_product(t84, t435);
    let t446 = (-(t62 * t444).add_product(t60, t445).add_product(t63, t443).add_product(t66, t438))
        .add_product(t68, t437).add_product(t70, t435);
    let t447 = (t53 * t445).add_product(t51, t446).add_product(t55, t435);
    let t448 = (t43 * t446).sub_product(t41, t447).add_product(t41, t445).sub_product(t45, t435);
    let drum_v_y_dot_by_rod_x = (t36 * t436).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t436);
    let drum_v_x_dot_by_rod_x = (t35 * t436).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t436);
    let bobbin_v_y_dot_by_rod_x = -(t34 * t436).add_product(c.inverse_bobbin_mass, t437);
    let bobbin_v_x_dot_by_rod_x = -(t33 * t436).add_product(c.inverse_bobbin_mass, t438);
    let rod_omega_dot_by_rod_x = (t31 * t440).sub_product(R::literal(4_166.666_666_666_667), t442)
        .sub_product(t32, t439);
    let rod_v_y_dot_by_rod_x = t430.sub_product(t30, t441).sub_product(R::literal(5.0), t439);
    let rod_v_x_dot_by_rod_x = t428.add_product(t29, t441).sub_product(R::literal(5.0), t440);
    let cylinder_omega_dot_by_rod_x = (t421 * R::literal(2_777.777_777_777_778)).sub_product(t26,
        t444).add_product(t27, t443).sub_product(R::literal(-2_777.777_777_777_778), t442)
        .add_product(t28, t441);
    let cylinder_v_y_dot_by_rod_x = t424.sub_product(R::literal(3.333_333_333_333_333_5), t443)
        .add_product(t25, t441);
    let cylinder_v_x_dot_by_rod_x = t422.sub_product(R::literal(3.333_333_333_333_333_5), t444)
        .sub_product(t24, t441);
    let plate_omega_dot_by_rod_x = (t21 * t445).sub_product(t20, t446).sub_product(t20, t444)
        .add_product(t21, t443).add_product(t22, t438).sub_product(t23, t437);
    let plate_v_y_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t443)
        .add_product(R::literal(-0.833_333_333_333_333_4), t445)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t437);
    let plate_v_x_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t444)
        .add_product(R::literal(-0.833_333_333_333_333_4), t446)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t438);
    let post_omega_dot_by_rod_x = (-(t18 * t447).add_product(t17, t448).add_product(t17, t446))
        .add_product(t18, t445).sub_product(t19, t435);
    let post_v_y_dot_by_rod_x = (R::literal(1.25) * t445).add_product(R::literal(1.25), t447);
    let post_v_x_dot_by_rod_x = (R::literal(1.25) * t446).add_product(R::literal(-1.25), t448);
    let t449 = t349 - t348;
    let t450 = t352.add_product(t26, t449);
    let t451 = (-t354).add_product(t27, t449).sub_product(t87, t450);
    let t452 = (R::literal(2_777.777_777_777_778) * t449).add_product(t89, t450).sub_product(t100,
        t451);
    let t453 = ((t351 - t357 + t358).add_product(t28, t449) - t359 + t360).sub_product(t91, t450)
        .sub_product(t102, t451).add_product(t111, t452);
    let t454 = t362.sub_product(t112, t452).sub_product(t122, t453);
    let t455 = t364.add_product(t113, t452).add_product(t124, t453).add_product(t133, t454);
    let t456 = (-(t93 * t450).add_product(t104, t451)).add_product(t115, t452).sub_product(t126,
        t453).add_product(t135, t454).sub_product(t142, t455);
    let t457 = (-(t95 * t450).add_product(t106, t451)).add_product(t117, t452).sub_product(t128,
        t453).add_product(t137, t454).sub_product(t144, t455).sub_product(t149, t456);
    let t458 = (t150 * t456).sub_product(t155, t457);
    let t459 = (-(t97 * t450).add_product(t108, t451)).add_product(t119, t452).sub_product(t130,
        t453).add_product(t139, t454).sub_product(t146, t455).sub_product(t152, t456)
        .sub_product(t157, t457).sub_product(t162, t458) * t163;
    let t460 = (t458 * t160).sub_product(t162, t459);
    let t461 = (t457 * t153).sub_product(t155, t460).sub_product(t157, t459);
    let t462 = (t456 * t147).sub_product(t149, t461).add_product(t150, t460).sub_product(t152,
        t459);
    let t463 = (t455 * t140).sub_product(t142, t462).sub_product(t144, t461).sub_product(t146,
        t459);
    let t464 = (-(t454 * t131)).add_product(t133, t463).add_product(t135, t462).add_product(t137,
        t461).add_product(t139, t459);
    let t465 = (t453 * t120).sub_product(t122, t464).add_product(t124, t463).sub_product(t126, t462)
        .sub_product(t128, t461).sub_product(t130, t459);
    let t466 = (t452 * t109).add_product(t111, t465).sub_product(t112, t464).add_product(t113, t463)
        .add_product(t115, t462).add_product(t117, t461).add_product(t119, t459);
    let t467 = (t451 * t98).sub_product(t100, t466).sub_product(t102, t465).sub_product(t104, t462)
        .sub_product(t106, t461).sub_product(t108, t459);
    let t468 = (t450 * t85).add_product(t87, t467).sub_product(t89, t466).add_product(t91, t465)
        .add_product(t93, t462).add_product(t95, t461).add_product(t97, t459);
    let t469 = (-(t76 * t467).add_product(t74, t468)).add_product(t79, t462).sub_product(t82, t461)
        .sub_product(t84, t459);
    let t470 = (-(t62 * t468).add_product(t60, t469).add_product(t63, t467).add_product(t66, t462))
        .add_product(t68, t461).add_product(t70, t459);
    let t471 = (t53 * t469).add_product(t51, t470).add_product(t55, t459);
    let t472 = (t43 * t470).sub_product(t41, t471).add_product(t41, t469).sub_product(t45, t459);
    let drum_v_y_dot_by_rod_y = (t36 * t460).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t460);
    let drum_v_x_dot_by_rod_y = (t35 * t460).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t460);
    let bobbin_v_y_dot_by_rod_y = -(t34 * t460).add_product(c.inverse_bobbin_mass, t461);
    let bobbin_v_x_dot_by_rod_y = -(t33 * t460).add_product(c.inverse_bobbin_mass, t462);
    let rod_omega_dot_by_rod_y = (t31 * t464).sub_product(R::literal(4_166.666_666_666_667), t466)
        .sub_product(t32, t463);
    let rod_v_y_dot_by_rod_y = (-t364.add_product(t30, t465)).add_product(R::literal(-5.0), t463);
    let rod_v_x_dot_by_rod_y = (-t362).add_product(t29, t465).sub_product(R::literal(5.0), t464);
    let cylinder_omega_dot_by_rod_y = (t449 * R::literal(2_777.777_777_777_778)).sub_product(t26,
        t468).add_product(t27, t467).sub_product(R::literal(-2_777.777_777_777_778), t466)
        .add_product(t28, t465);
    let cylinder_v_y_dot_by_rod_y = t354.sub_product(R::literal(3.333_333_333_333_333_5), t467)
        .add_product(t25, t465);
    let cylinder_v_x_dot_by_rod_y = t352.sub_product(R::literal(3.333_333_333_333_333_5), t468)
        .sub_product(t24, t465);
    let plate_omega_dot_by_rod_y = (t21 * t469).sub_product(t20, t470).sub_product(t20, t468)
        .add_product(t21, t467).add_product(t22, t462).sub_product(t23, t461);
    let plate_v_y_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t467)
        .add_product(R::literal(-0.833_333_333_333_333_4), t469)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t461);
    let plate_v_x_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t468)
        .add_product(R::literal(-0.833_333_333_333_333_4), t470)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t462);
    let post_omega_dot_by_rod_y = (-(t18 * t471).add_product(t17, t472).add_product(t17, t470))
        .add_product(t18, t469).sub_product(t19, t459);
    let post_v_y_dot_by_rod_y = (R::literal(1.25) * t469).add_product(R::literal(1.25), t471);
    let post_v_x_dot_by_rod_y = (R::literal(1.25) * t470).add_product(R::literal(-1.25), t472);
    let t473 = (t7 * t235).add_product(t6, t236);
    let t474 = R::literal(4_166.666_666_666_667) * t473;
    let t475 = t111 * t474;
    let t476 = (-t195).add_product(t6, rod_omega_dot).add_product(t31, t473).add_product(t112, t474)
        .add_product(t122, t475);
    let t477 = t194.add_product(t7, rod_omega_dot).sub_product(t32, t473).sub_product(t113, t474)
        .sub_product(t124, t475).add_product(t133, t476);
    let t478 = (-(t115 * t474)).add_product(t126, t475).add_product(t135, t476).sub_product(t142,
        t477);
    let t479 = (-(t117 * t474)).add_product(t128, t475).add_product(t137, t476).sub_product(t144,
        t477).sub_product(t149, t478);
    let t480 = (t150 * t478).sub_product(t155, t479);
    let t481 = (-(t119 * t474)).add_product(t130, t475).add_product(t139, t476).sub_product(t146,
        t477).sub_product(t152, t478).sub_product(t157, t479).sub_product(t162, t480) * t163;
    let t482 = (t480 * t160).sub_product(t162, t481);
    let t483 = (t479 * t153).sub_product(t155, t482).sub_product(t157, t481);
    let t484 = (t478 * t147).sub_product(t149, t483).add_product(t150, t482).sub_product(t152,
        t481);
    let t485 = (t477 * t140).sub_product(t142, t484).sub_product(t144, t483).sub_product(t146,
        t481);
    let t486 = (-(t476 * t131)).add_product(t133, t485).add_product(t135, t484).add_product(t137,
        t483).add_product(t139, t481);
    let t487 = (-(t475 * t120).add_product(t122, t486)).add_product(t124, t485).sub_product(t126,
        t484).sub_product(t128, t483).sub_product(t130, t481);
    let t488 = (-(t474 * t109)).add_product(t111, t487).sub_product(t112, t486).add_product(t113,
        t485).add_product(t115, t484).add_product(t117, t483).add_product(t119, t481);
    let t489 = (t102 * t487).add_product(t100, t488).add_product(t104, t484).add_product(t106, t483)
        .add_product(t108, t481);
    let t490 = (-(t89 * t488).add_product(t87, t489)).add_product(t91, t487).add_product(t93, t484)
        .add_product(t95, t483).add_product(t97, t481);
    let t491 = (t76 * t489).sub_product(t74, t490).add_product(t79, t484).sub_product(t82, t483)
        .sub_product(t84, t481);
    let t492 = (-(t62 * t490).add_product(t60, t491)).add_product(t63, t489).sub_product(t66, t484)
        .add_product(t68, t483).add_product(t70, t481);
    let t493 = (t53 * t491).add_product(t51, t492).add_product(t55, t481);
    let t494 = (t43 * t492).sub_product(t41, t493).add_product(t41, t491).sub_product(t45, t481);
    let drum_v_y_dot_by_rod_phi = (t36 * t482).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t482);
    let drum_v_x_dot_by_rod_phi = (t35 * t482).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t482);
    let bobbin_v_y_dot_by_rod_phi = -(t34 * t482).add_product(c.inverse_bobbin_mass, t483);
    let bobbin_v_x_dot_by_rod_phi = -(t33 * t482).add_product(c.inverse_bobbin_mass, t484);
    let rod_omega_dot_by_rod_phi = t474.sub_product(R::literal(4_166.666_666_666_667), t488)
        .add_product(t31, t486).sub_product(t32, t485);
    let rod_v_y_dot_by_rod_phi = (R::literal(-5.0) * t485).sub_product(t30, t487);
    let rod_v_x_dot_by_rod_phi = (R::literal(-5.0) * t486).add_product(t29, t487);
    let cylinder_omega_dot_by_rod_phi = (-(t27 * t489).add_product(t26, t490)
        .add_product(R::literal(-2_777.777_777_777_778), t488)).add_product(t28, t487);
    let cylinder_v_y_dot_by_rod_phi = (t25 * t487).add_product(R::literal(3.333_333_333_333_333_5),
        t489);
    let cylinder_v_x_dot_by_rod_phi = (-(t24 * t487))
        .add_product(R::literal(-3.333_333_333_333_333_5), t490);
    let plate_omega_dot_by_rod_phi = (t21 * t491).sub_product(t20, t492).sub_product(t20, t490)
        .sub_product(t21, t489).add_product(t22, t484).sub_product(t23, t483);
    let plate_v_y_dot_by_rod_phi = (R::literal(-0.833_333_333_333_333_4) * t489)
        .sub_product(R::literal(0.833_333_333_333_333_4), t491)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t483);
    let plate_v_x_dot_by_rod_phi = (R::literal(0.833_333_333_333_333_4) * t490)
        .add_product(R::literal(-0.833_333_333_333_333_4), t492)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t484);
    let post_omega_dot_by_rod_phi = (-(t18 * t493).add_product(t17, t494).add_product(t17, t492))
        .add_product(t18, t491).sub_product(t19, t481);
    let post_v_y_dot_by_rod_phi = (R::literal(1.25) * t491).add_product(R::literal(1.25), t493);
    let post_v_x_dot_by_rod_phi = (R::literal(1.25) * t492).add_product(R::literal(-1.25), t494);
    let t495 = t175 * bobbin_y_minus_drum_y / between_squared_times_between;
    let bobbin_x_plus_between_minus_drum_x = bobbin_x + between - drum_x;
    let bobbin_x_minus_drum_x_minus_between = bobbin_x_minus_drum_x - between;
    let t496 = p.winding_force * bobbin_x_plus_between_minus_drum_x
        * bobbin_x_minus_drum_x_minus_between / between_squared_times_between;
    let t497 = R::literal(3.0) * bobbin_v_x;
    let t498 = t497 * bobbin_x_minus_drum_x;
    let t499 = t498 / between_squared_times_between;
    let t500 = between.powi(5);
    let t501 = bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t502 = R::literal(3.0) * drum_v_x;
    let t503 = t502 * t501 / t500;
    let t504 = R::literal(3.0) * drum_v_y;
    let t505 = t504 * bobbin_y_minus_drum_y;
    let t506 = t505 * bobbin_x_minus_drum_x_squared / t500;
    let t507 = bobbin_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t508 = t497 * t501 / t500;
    let t509 = R::literal(3.0) * bobbin_v_y;
    let t510 = t509 * bobbin_y_minus_drum_y;
    let t511 = t510 * bobbin_x_minus_drum_x_squared / t500;
    let t512 = t502 * bobbin_x_minus_drum_x;
    let t513 = t512 / between_squared_times_between;
    let t514 = drum_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t515 = t508 + t511 + t513 + t514 - t499 - t503 - t506 - t507;
    let t516 = t502 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t500;
    let t517 = t504 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t500;
    let t518 = bobbin_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t519 = t199 / between_squared_times_between;
    let t520 = t497 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t500;
    let t521 = t509 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t500;
    let t522 = drum_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t523 = drum_v_y_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t524 = t520 + t521 + t522 + t523 - t516 - t517 - t518 - t519;
    let t525 = t499 + t503 + t506 + t507 - t508 - t511 - t513 - t514;
    let t526 = t516 + t517 + t518 + t519 - t520 - t521 - t522 - t523;
    let t527 = bobbin_x_plus_between_minus_drum_x * bobbin_x_minus_drum_x_minus_between
        / between_squared_times_between;
    let t528 = t527 * t232;
    let t529 = t495 + t528;
    let t530 = t527 * t245;
    let t531 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t532 = t531 * t232;
    let t533 = t532 - t496;
    let t534 = t531 * bobbin_v_y_dot;
    let t535 = t527 * drum_v_x_dot;
    let t536 = t531 * drum_v_y_dot;
    let t537 = c.inverse_bobbin_mass * t529;
    let t538 = c.inverse_bobbin_mass * t533;
    let t539 = t149 * t537;
    let t540 = t539 - t538;
    let t541 = R::literal(0.666_666_666_666_666_6) * t528;
    let t542 = R::literal(0.666_666_666_666_666_6) * t532;
    let t543 = t33 * t529;
    let t544 = t35 * t528;
    let t545 = t36 * t532;
    let t546 = t150 * t537;
    let t547 = bobbin_x_minus_drum_x_over_between * t541;
    let t548 = bobbin_y_minus_drum_y_over_between * t542;
    let t549 = ((t534 - ((bobbin_v_x * t515).add_product(bobbin_v_y, t524).add_product(drum_v_x,
        t525).add_product(drum_v_y, t526) + t530) - t535 - t536 - t543).sub_product(t34, t533)
        - t544 - t545 - t546).sub_product(t155, t540) + t547 + t548;
    let t550 = t152 * t537;
    let t551 = t537 * t147;
    let t552 = t550.sub_product(t157, t540).sub_product(t162, t549) * t163;
    let t553 = (t549 * t160).sub_product(t162, t552);
    let t554 = (t540 * t153).sub_product(t155, t553).sub_product(t157, t552);
    let t555 = (-t551.add_product(t149, t554)).add_product(t150, t553).sub_product(t152, t552);
    let t556 = (t144 * t554).add_product(t142, t555).add_product(t146, t552);
    let t557 = (t135 * t555).sub_product(t133, t556).add_product(t137, t554).add_product(t139,
        t552);
    let t558 = (t124 * t556).add_product(t122, t557).add_product(t126, t555).add_product(t128, t554)
        .add_product(t130, t552);
    let t559 = (-(t112 * t557).add_product(t111, t558).add_product(t113, t556)).add_product(t115,
        t555).add_product(t117, t554).add_product(t119, t552);
    let t560 = (t102 * t558).sub_product(t100, t559).sub_product(t104, t555).sub_product(t106, t554)
        .sub_product(t108, t552);
    let t561 = (-(t89 * t559)).add_product(t87, t560).sub_product(t91, t558).add_product(t93, t555)
        .add_product(t95, t554).add_product(t97, t552);
    let t562 = (-(t76 * t560).add_product(t74, t561)).add_product(t79, t555).sub_product(t82, t554)
        .sub_product(t84, t552);
    let t563 = (-(t62 * t561).add_product(t60, t562).add_product(t63, t560).add_product(t66, t555))
        .add_product(t68, t554).add_product(t70, t552);
    let t564 = (t53 * t562).add_product(t51, t563).add_product(t55, t552);
    let t565 = (t43 * t563).sub_product(t41, t564).add_product(t41, t562).sub_product(t45, t552);
    let drum_v_y_dot_by_bobbin_x = (-t542.add_product(R::literal(0.666_666_666_666_666_6), (-t532)
        .add_product(bobbin_y_minus_drum_y_over_between, t553))).add_product(t36, t553);
    let drum_v_x_dot_by_bobbin_x = (-t541.add_product(R::literal(0.666_666_666_666_666_6), (-t528)
        .add_product(bobbin_x_minus_drum_x_over_between, t553))).add_product(t35, t553);
    let bobbin_v_y_dot_by_bobbin_x = t538.sub_product(c.inverse_bobbin_mass, t554).sub_product(t34,
        t553);
    let bobbin_v_x_dot_by_bobbin_x = t537.sub_product(c.inverse_bobbin_mass, t555).sub_product(t33,
        t553);
    let rod_omega_dot_by_bobbin_x = (t31 * t557).sub_product(R::literal(4_166.666_666_666_667),
        t559).add_product(t32, t556);
    let rod_v_y_dot_by_bobbin_x = (R::literal(5.0) * t556).add_product(t30, t558);
    let rod_v_x_dot_by_bobbin_x = (R::literal(-5.0) * t557).sub_product(t29, t558);
    let cylinder_omega_dot_by_bobbin_x = (t27 * t560).sub_product(t26, t561)
        .sub_product(R::literal(-2_777.777_777_777_778), t559).sub_product(t28, t558);
    let cylinder_v_y_dot_by_bobbin_x = (-(t25 * t558))
        .add_product(R::literal(-3.333_333_333_333_333_5), t560);
    let cylinder_v_x_dot_by_bobbin_x = (t24 * t558)
        .sub_product(R::literal(3.333_333_333_333_333_5), t561);
    let plate_omega_dot_by_bobbin_x = (t21 * t562).sub_product(t20, t563).sub_product(t20, t561)
        .add_product(t21, t560).add_product(t22, t555).sub_product(t23, t554);
    let plate_v_y_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t560)
        .add_product(R::literal(-0.833_333_333_333_333_4), t562)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t554);
    let plate_v_x_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t561)
        .add_product(R::literal(-0.833_333_333_333_333_4), t563)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t555);
    let post_omega_dot_by_bobbin_x = (-(t18 * t564).add_product(t17, t565).add_product(t17, t563))
        .add_product(t18, t562).sub_product(t19, t552);
    let post_v_y_dot_by_bobbin_x = (R::literal(1.25) * t562).add_product(R::literal(1.25), t564);
    let post_v_x_dot_by_bobbin_x = (R::literal(1.25) * t563).add_product(R::literal(-1.25), t565);
    let bobbin_y_plus_between_minus_drum_y = bobbin_y + between - drum_y;
    let bobbin_y_minus_drum_y_minus_between = bobbin_y_minus_drum_y - between;
    let t566 = t510 / between_squared_times_between;
    let t567 = t512 * bobbin_y_minus_drum_y_squared / t500;
    let t568 = bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t569 = t504 * t568 / t500;
    let t570 = t203 / between_squared_times_between;
    let t571 = t498 * bobbin_y_minus_drum_y_squared / t500;
    let t572 = t509 * t568 / t500;
    let t573 = t505 / between_squared_times_between;
    let t574 = drum_v_x_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t575 = t571 + t572 + t573 + t574 - t566 - t567 - t569 - t570;
    let t576 = t566 + t567 + t569 + t570 - t571 - t572 - t573 - t574;
    let t577 = p.winding_force * bobbin_y_plus_between_minus_drum_y
        * bobbin_y_minus_drum_y_minus_between / between_squared_times_between + t532;
    let t578 = t531 * t245;
    let t579 = bobbin_y_plus_between_minus_drum_y * bobbin_y_minus_drum_y_minus_between
        / between_squared_times_between;
    let t580 = t579 * t232;
    let t581 = t580 - t495;
    let t582 = t579 * bobbin_v_y_dot;
    let t583 = t531 * drum_v_x_dot;
    let t584 = t579 * drum_v_y_dot;
    let t585 = c.inverse_bobbin_mass * t577;
    let t586 = c.inverse_bobbin_mass * t581;
    let t587 = t149 * t585;
    let t588 = t587 - t586;
    let t589 = R::literal(0.666_666_666_666_666_6) * t580;
    let t590 = t33 * t577;
    let t591 = t35 * t532;
    let t592 = t36 * t580;
    let t593 = t150 * t585;
    let t594 = bobbin_x_minus_drum_x_over_between * t542;
    let t595 = bobbin_y_minus_drum_y_over_between * t589;
    let t596 = ((t582 - ((bobbin_v_x * t524).add_product(bobbin_v_y, t575).add_product(drum_v_x,
        t526).add_product(drum_v_y, t576) + t578) - t583 - t584 - t590).sub_product(t34, t581)
        - t591 - t592 - t593).sub_product(t155, t588) + t594 + t595;
    let t597 = t152 * t585;
    let t598 = t585 * t147;
    let t599 = t597.sub_product(t157, t588).sub_product(t162, t596) * t163;
    let t600 = (t596 * t160).sub_product(t162, t599);
    let t601 = (t588 * t153).sub_product(t155, t600).sub_product(t157, t599);
    let t602 = (-t598.add_product(t149, t601)).add_product(t150, t600).sub_product(t152, t599);
    let t603 = (t144 * t601).add_product(t142, t602).add_product(t146, t599);
    let t604 = (t135 * t602).sub_product(t133, t603).add_product(t137, t601).add_product(t139,
        t599);
    let t605 = (t124 * t603).add_product(t122, t604).add_product(t126, t602).add_product(t128, t601)
        .add_product(t130, t599);
    let t606 = (-(t112 * t604).add_product(t111, t605).add_product(t113, t603)).add_product(t115,
        t602).add_product(t117, t601).add_product(t119, t599);
    let t607 = (t102 * t605).sub_product(t100, t606).sub_product(t104, t602).sub_product(t106, t601)
        .sub_product(t108, t599);
    let t608 = (-(t89 * t606)).add_product(t87, t607).sub_product(t91, t605).add_product(t93, t602)
        .add_product(t95, t601).add_product(t97, t599);
    let t609 = (-(t76 * t607).add_product(t74, t608)).add_product(t79, t602).sub_product(t82, t601)
        .sub_product(t84, t599);
    let t610 = (-(t62 * t608).add_product(t60, t609).add_product(t63, t607).add_product(t66, t602))
        .add_product(t68, t601).add_product(t70, t599);
    let t611 = (t53 * t609).add_product(t51, t610).add_product(t55, t599);
    let t612 = (t43 * t610).sub_product(t41, t611).add_product(t41, t609).sub_product(t45, t599);
    let drum_v_y_dot_by_bobbin_y = (-t589.add_product(R::literal(0.666_666_666_666_666_6), (-t580)
        .add_product(bobbin_y_minus_drum_y_over_between, t600))).add_product(t36, t600);
    let drum_v_x_dot_by_bobbin_y = (-t542.add_product(R::literal(0.666_666_666_666_666_6), (-t532)
        .add_product(bobbin_x_minus_drum_x_over_between, t600))).add_product(t35, t600);
    let bobbin_v_y_dot_by_bobbin_y = t586.sub_product(c.inverse_bobbin_mass, t601).sub_product(t34,
        t600);
    let bobbin_v_x_dot_by_bobbin_y = t585.sub_product(c.inverse_bobbin_mass, t602).sub_product(t33,
        t600);
    let rod_omega_dot_by_bobbin_y = (t31 * t604).sub_product(R::literal(4_166.666_666_666_667),
        t606).add_product(t32, t603);
    let rod_v_y_dot_by_bobbin_y = (R::literal(5.0) * t603).add_product(t30, t605);
    let rod_v_x_dot_by_bobbin_y = (R::literal(-5.0) * t604).sub_product(t29, t605);
    let cylinder_omega_dot_by_bobbin_y = (t27 * t607).sub_product(t26, t608)
        .sub_product(R::literal(-2_777.777_777_777_778), t606).sub_product(t28, t605);
    let cylinder_v_y_dot_by_bobbin_y = (-(t25 * t605))
        .add_product(R::literal(-3.333_333_333_333_333_5), t607);
    let cylinder_v_x_dot_by_bobbin_y = (t24 * t605)
        .sub_product(R::literal(3.333_333_333_333_333_5), t608);
    let plate_omega_dot_by_bobbin_y = (t21 * t609).sub_product(t20, t610).sub_product(t20, t608)
        .add_product(t21, t607).add_product(t22, t602).sub_product(t23, t601);
    let plate_v_y_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t607)
        .add_product(R::literal(-0.833_333_333_333_333_4), t609)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t601);
    let plate_v_x_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t608)
        .add_product(R::literal(-0.833_333_333_333_333_4), t610)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t602);
    let post_omega_dot_by_bobbin_y = (-(t18 * t611).add_product(t17, t612).add_product(t17, t610))
        .add_product(t18, t609).sub_product(t19, t599);
    let post_v_y_dot_by_bobbin_y = (R::literal(1.25) * t609).add_product(R::literal(1.25), t611);
    let post_v_x_dot_by_bobbin_y = (R::literal(1.25) * t610).add_product(R::literal(-1.25), t612);
    let t613 = t496 - t532;
    let t614 = c.inverse_bobbin_mass * t613;
    let t615 = t614 + t539;
    let t616 = ((t530 - (bobbin_v_y * t526).add_product(bobbin_v_x, t525).add_product(drum_v_x,
        t515).add_product(drum_v_y, t524) - t534 + t535 + t536 + t543).sub_product(t34, t613)
        + t544 + t545 + t546).add_product(t155, t615) - t547 - t548;
    let t617 = (-t550).add_product(t157, t615).sub_product(t162, t616) * t163;
    let t618 = (t616 * t160).sub_product(t162, t617);
    let t619 = (t615 * t153).add_product(t155, t618).add_product(t157, t617);
    let t620 = t551.add_product(t149, t619).add_product(t150, t618).sub_product(t152, t617);
    let t621 = (t144 * t619).sub_product(t142, t620).sub_product(t146, t617);
    let t622 = (t135 * t620).add_product(t133, t621).sub_product(t137, t619).add_product(t139,
        t617);
    let t623 = (t124 * t621).sub_product(t122, t622).sub_product(t126, t620).add_product(t128, t619)
        .sub_product(t130, t617);
    let t624 = (-(t112 * t622)).add_product(t111, t623).add_product(t113, t621).add_product(t115,
        t620).sub_product(t117, t619).add_product(t119, t617);
    let t625 = (-(t102 * t623).add_product(t100, t624).add_product(t104, t620)).add_product(t106,
        t619).sub_product(t108, t617);
    let t626 = (-(t89 * t624)).add_product(t87, t625).add_product(t91, t623).add_product(t93, t620)
        .sub_product(t95, t619).add_product(t97, t617);
    let t627 = (-(t76 * t625).add_product(t74, t626)).add_product(t79, t620).add_product(t82, t619)
        .sub_product(t84, t617);
    let t628 = (-(t62 * t626).add_product(t60, t627).add_product(t63, t625).add_product(t66, t620)
        .add_product(t68, t619)).add_product(t70, t617);
    let t629 = (t53 * t627).add_product(t51, t628).add_product(t55, t617);
    let t630 = (t43 * t628).sub_product(t41, t629).add_product(t41, t627).sub_product(t45, t617);
    let drum_v_y_dot_by_drum_x = t542.sub_product(R::literal(0.666_666_666_666_666_6), t532
        .add_product(bobbin_y_minus_drum_y_over_between, t618)).add_product(t36, t618);
    let drum_v_x_dot_by_drum_x = t541.sub_product(R::literal(0.666_666_666_666_666_6), t528
        .add_product(bobbin_x_minus_drum_x_over_between, t618)).add_product(t35, t618);
    let bobbin_v_y_dot_by_drum_x = t614.add_product(c.inverse_bobbin_mass, t619).sub_product(t34,
        t618);
    let bobbin_v_x_dot_by_drum_x = -t537.add_product(c.inverse_bobbin_mass, t620).add_product(t33,
        t618);
    let rod_omega_dot_by_drum_x = (t31 * t622).sub_product(R::literal(4_166.666_666_666_667), t624)
        .sub_product(t32, t621);
    let rod_v_y_dot_by_drum_x = (R::literal(-5.0) * t621).sub_product(t30, t623);
    let rod_v_x_dot_by_drum_x = (R::literal(-5.0) * t622).add_product(t29, t623);
    let cylinder_omega_dot_by_drum_x = (t27 * t625).sub_product(t26, t626)
        .sub_product(R::literal(-2_777.777_777_777_778), t624).add_product(t28, t623);
    let cylinder_v_y_dot_by_drum_x = (t25 * t623).sub_product(R::literal(3.333_333_333_333_333_5),
        t625);
    let cylinder_v_x_dot_by_drum_x = (-(t24 * t623))
        .add_product(R::literal(-3.333_333_333_333_333_5), t626);
    let plate_omega_dot_by_drum_x = (t21 * t627).sub_product(t20, t628).sub_product(t20, t626)
        .add_product(t21, t625).add_product(t22, t620).add_product(t23, t619);
    let plate_v_y_dot_by_drum_x = (-(R::literal(-0.833_333_333_333_333_4) * t625)
        .add_product(R::literal(0.833_333_333_333_333_4), t627))
        .add_product(R::literal(-0.833_333_333_333_333_4), t619);
    let plate_v_x_dot_by_drum_x = (R::literal(0.833_333_333_333_333_4) * t626)
        .add_product(R::literal(-0.833_333_333_333_333_4), t628)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t620);
    let post_omega_dot_by_drum_x = (-(t18 * t629).add_product(t17, t630).add_product(t17, t628))
        .add_product(t18, t627).sub_product(t19, t617);
    let post_v_y_dot_by_drum_x = (R::literal(1.25) * t627).add_product(R::literal(1.25), t629);
    let post_v_x_dot_by_drum_x = (R::literal(1.25) * t628).add_product(R::literal(-1.25), t630);
    let t631 = t495 - t580;
    let t632 = c.inverse_bobbin_mass * t631;
    let t633 = t632 + t587;
    let t634 = ((t578 - (bobbin_v_x * t526).add_product(bobbin_v_y, t576).add_product(drum_v_x,
        t524).add_product(drum_v_y, t575) - t582 + t583 + t584 + t590).sub_product(t34, t631)
        + t591 + t592 + t593).add_product(t155, t633) - t594 - t595;
    let t635 = (-t597).add_product(t157, t633).sub_product(t162, t634) * t163;
    let t636 = (t634 * t160).sub_product(t162, t635);
    let t637 = (t633 * t153).add_product(t155, t636).add_product(t157, t635);
    let t638 = t598.add_product(t149, t637).add_product(t150, t636).sub_product(t152, t635);
    let t639 = (t144 * t637).sub_product(t142, t638).sub_product(t146, t635);
    let t640 = (t135 * t638).add_product(t133, t639).sub_product(t137, t637).add_product(t139,
        t635);
    let t641 = (t124 * t639).sub_product(t122, t640).sub_product(t126, t638).add_product(t128, t637)
        .sub_product(t130, t635);
    let t642 = (-(t112 * t640)).add_product(t111, t641).add_product(t113, t639).add_product(t115,
        t638).sub_product(t117, t637).add_product(t119, t635);
    let t643 = (-(t102 * t641).add_product(t100, t642).add_product(t104, t638)).add_product(t106,
        t637).sub_product(t108, t635);
    let t644 = (-(t89 * t642)).add_product(t87, t643).add_product(t91, t641).add_product(t93, t638)
        .sub_product(t95, t637).add_product(t97, t635);
    let t645 = (-(t76 * t643).add_product(t74, t644)).add_product(t79, t638).add_product(t82, t637)
        .sub_product(t84, t635);
    let t646 = (-(t62 * t644).add_product(t60, t645).add_product(t63, t643).add_product(t66, t638)
        .add_product(t68, t637)).add_product(t70, t635);
    let t647 = (t53 * t645).add_product(t51, t646).add_product(t55, t635);
    let t648 = (t43 * t646).sub_product(t41, t647).add_product(t41, t645).sub_product(t45, t635);
    let drum_v_y_dot_by_drum_y = t589.sub_product(R::literal(0.666_666_666_666_666_6), t580
        .add_product(bobbin_y_minus_drum_y_over_between, t636)).add_product(t36, t636);
    let drum_v_x_dot_by_drum_y = t542.sub_product(R::literal(0.666_666_666_666_666_6), t532
        .add_product(bobbin_x_minus_drum_x_over_between, t636)).add_product(t35, t636);
    let bobbin_v_y_dot_by_drum_y = t632.add_product(c.inverse_bobbin_mass, t637).sub_product(t34,
        t636);
    let bobbin_v_x_dot_by_drum_y = -t585.add_product(c.inverse_bobbin_mass, t638).add_product(t33,
        t636);
    let rod_omega_dot_by_drum_y = (t31 * t640).sub_product(R::literal(4_166.666_666_666_667), t642)
        .sub_product(t32, t639);
    let rod_v_y_dot_by_drum_y = (R::literal(-5.0) * t639).sub_product(t30, t641);
    let rod_v_x_dot_by_drum_y = (R::literal(-5.0) * t640).add_product(t29, t641);
    let cylinder_omega_dot_by_drum_y = (t27 * t643).sub_product(t26, t644)
        .sub_product(R::literal(-2_777.777_777_777_778), t642).add_product(t28, t641);
    let cylinder_v_y_dot_by_drum_y = (t25 * t641).sub_product(R::literal(3.333_333_333_333_333_5),
        t643);
    let cylinder_v_x_dot_by_drum_y = (-(t24 * t641))
        .add_product(R::literal(-3.333_333_333_333_333_5), t644);
    let plate_omega_dot_by_drum_y = (t21 * t645).sub_product(t20, t646).sub_product(t20, t644)
        .add_product(t21, t643).add_product(t22, t638).add_product(t23, t637);
    let plate_v_y_dot_by_drum_y = (-(R::literal(-0.833_333_333_333_333_4) * t643)
        .add_product(R::literal(0.833_333_333_333_333_4), t645))
        .add_product(R::literal(-0.833_333_333_333_333_4), t637);
    let plate_v_x_dot_by_drum_y = (R::literal(0.833_333_333_333_333_4) * t644)
        .add_product(R::literal(-0.833_333_333_333_333_4), t646)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t638);
    let post_omega_dot_by_drum_y = (-(t18 * t647).add_product(t17, t648).add_product(t17, t646))
        .add_product(t18, t645).sub_product(t19, t635);
    let post_v_y_dot_by_drum_y = (R::literal(1.25) * t645).add_product(R::literal(1.25), t647);
    let post_v_x_dot_by_drum_y = (R::literal(1.25) * t646).add_product(R::literal(-1.25), t648);
    let t649 = R::literal(0.2) * post_omega;
    let t650 = t649 * cos_post_phi;
    let t651 = (t649 * sin_post_phi).add_product(t41, t650);
    let t652 = (-t650.add_product(t43, t650)).add_product(t51, t651);
    let t653 = (-t651).add_product(t53, t651).sub_product(t60, t652);
    let t654 = (t62 * t652).add_product(t74, t653);
    let t655 = (t63 * t652).add_product(t76, t653).add_product(t87, t654);
    let t656 = (t89 * t654).add_product(t100, t655);
    let t657 = (-(t91 * t654)).add_product(t102, t655).add_product(t111, t656);
    let t658 = (t112 * t656).add_product(t122, t657);
    let t659 = (t113 * t656).add_product(t124, t657).sub_product(t133, t658);
    let t660 = (-(t66 * t652)).add_product(t79, t653).sub_product(t93, t654).add_product(t104, t655)
        .add_product(t115, t656).sub_product(t126, t657).sub_product(t135, t658).sub_product(t142,
        t659);
    let t661 = (t68 * t652).sub_product(t82, t653).sub_product(t95, t654).add_product(t106, t655)
        .add_product(t117, t656).sub_product(t128, t657).sub_product(t137, t658).sub_product(t144,
        t659).sub_product(t149, t660);
    let t662 = (t150 * t660).sub_product(t155, t661);
    let t663 = (post_omega * (R::literal(0.286) * sin_post_phi).sub_product(R::literal(0.088),
        cos_post_phi)).add_product(t45, t650).add_product(t55, t651).add_product(t70, t652)
        .sub_product(t84, t653).sub_product(t97, t654).add_product(t108, t655).add_product(t119,
        t656).sub_product(t130, t657).sub_product(t139, t658).sub_product(t146, t659)
        .sub_product(t152, t660).sub_product(t157, t661).sub_product(t162, t662) * t163;
    let t664 = (t662 * t160).sub_product(t162, t663);
    let t665 = (t661 * t153).sub_product(t155, t664).sub_product(t157, t663);
    let t666 = (t660 * t147).sub_product(t149, t665).add_product(t150, t664).sub_product(t152,
        t663);
    let t667 = (t659 * t140).sub_product(t142, t666).sub_product(t144, t665).sub_product(t146,
        t663);
    let t668 = (t658 * t131).add_product(t133, t667).add_product(t135, t666).add_product(t137, t665)
        .add_product(t139, t663);
    let t669 = (t657 * t120).sub_product(t122, t668).add_product(t124, t667).sub_product(t126, t666)
        .sub_product(t128, t665).sub_product(t130, t663);
    let t670 = (t656 * t109).add_product(t111, t669).sub_product(t112, t668).add_product(t113, t667)
        .add_product(t115, t666).add_product(t117, t665).add_product(t119, t663);
    let t671 = (t655 * t98).add_product(t100, t670).add_product(t102, t669).add_product(t104, t666)
        .add_product(t106, t665).add_product(t108, t663);
    let t672 = (t654 * t85).sub_product(t87, t671).sub_product(t89, t670).add_product(t91, t669)
        .add_product(t93, t666).add_product(t95, t665).add_product(t97, t663);
    let t673 = (t653 * t72).sub_product(t74, t672).add_product(t76, t671).add_product(t79, t666)
        .sub_product(t82, t665).sub_product(t84, t663);
    let t674 = (t652 * t57).sub_product(t60, t673).sub_product(t62, t672).add_product(t63, t671)
        .sub_product(t66, t666).add_product(t68, t665).add_product(t70, t663);
    let t675 = (t651 * t49).add_product(t51, t674).add_product(t53, t673).add_product(t55, t663);
    let t676 = (t650 * t39).sub_product(t41, t675).add_product(t43, t674).add_product(t41, t673)
        .sub_product(t45, t663);
    let drum_v_y_dot_by_post_omega = (t36 * t664).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t664);
    let drum_v_x_dot_by_post_omega = (t35 * t664).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t664);
    let bobbin_v_y_dot_by_post_omega = -(t34 * t664).add_product(c.inverse_bobbin_mass, t665);
    let bobbin_v_x_dot_by_post_omega = -(t33 * t664).add_product(c.inverse_bobbin_mass, t666);
    let rod_omega_dot_by_post_omega = (t31 * t668).sub_product(R::literal(4_166.666_666_666_667),
        t670).sub_product(t32, t667);
    let rod_v_y_dot_by_post_omega = (R::literal(-5.0) * t667).sub_product(t30, t669);
    let rod_v_x_dot_by_post_omega = (R::literal(-5.0) * t668).add_product(t29, t669);
    let cylinder_omega_dot_by_post_omega = (-(t27 * t671).add_product(t26, t672)
        .add_product(R::literal(-2_777.777_777_777_778), t670)).add_product(t28, t669);
    let cylinder_v_y_dot_by_post_omega = (t25 * t669)
        .add_product(R::literal(3.333_333_333_333_333_5), t671);
    let cylinder_v_x_dot_by_post_omega = (-(t24 * t669))
        .add_product(R::literal(-3.333_333_333_333_333_5), t672);
    let plate_omega_dot_by_post_omega = (t21 * t673).sub_product(t20, t674).sub_product(t20, t672)
        .sub_product(t21, t671).add_product(t22, t666).sub_product(t23, t665);
    let plate_v_y_dot_by_post_omega = (R::literal(-0.833_333_333_333_333_4) * t671)
        .sub_product(R::literal(0.833_333_333_333_333_4), t673)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t665);
    let plate_v_x_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t672)
        .add_product(R::literal(-0.833_333_333_333_333_4), t674)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t666);
    let post_omega_dot_by_post_omega = (-(t18 * t675).add_product(t17, t676).add_product(t17, t674))
        .add_product(t18, t673).sub_product(t19, t663);
    let post_v_y_dot_by_post_omega = (R::literal(1.25) * t673).add_product(R::literal(1.25), t675);
    let post_v_x_dot_by_post_omega = (R::literal(1.25) * t674).add_product(R::literal(-1.25), t676);
    let t677 = R::literal(0.12) * plate_omega;
    let t678 = t677 * cos_plate_phi;
    let t679 = t677 * sin_plate_phi;
    let t680 = (-t679).add_product(t60, t678);
    let t681 = (-t678).add_product(t62, t678).sub_product(t74, t680);
    let t682 = (-t679).add_product(t63, t678).sub_product(t76, t680).add_product(t87, t681);
    let t683 = (t89 * t681).add_product(t100, t682);
    let t684 = (t91 * t681).sub_product(t102, t682).sub_product(t111, t683);
    let t685 = (t112 * t683).sub_product(t122, t684);
    let t686 = (-(t113 * t683)).add_product(t124, t684).add_product(t133, t685);
    let t687 = (plate_omega * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2),
        sin_plate_phi)).add_product(t66, t678).add_product(t79, t680).add_product(t93, t681)
        .sub_product(t104, t682).sub_product(t115, t683).sub_product(t126, t684).add_product(t135,
        t685).sub_product(t142, t686);
    let t688 = (plate_omega * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2),
        cos_plate_phi)).sub_product(t68, t678).sub_product(t82, t680).add_product(t95, t681)
        .sub_product(t106, t682).sub_product(t117, t683).sub_product(t128, t684).add_product(t137,
        t685).sub_product(t144, t686).sub_product(t149, t687);
    let t689 = (t150 * t687).sub_product(t155, t688);
    let t690 = (-(t70 * t678).add_product(t84, t680)).add_product(t97, t681).sub_product(t108, t682)
        .sub_product(t119, t683).sub_product(t130, t684).add_product(t139, t685).sub_product(t146,
        t686).sub_product(t152, t687).sub_product(t157, t688).sub_product(t162, t689) * t163;
    let t691 = (t689 * t160).sub_product(t162, t690);
    let t692 = (t688 * t153).sub_product(t155, t691).sub_product(t157, t690);
    let t693 = (t687 * t147).sub_product(t149, t692).add_product(t150, t691).sub_product(t152,
        t690);
    let t694 = (t686 * t140).sub_product(t142, t693).sub_product(t144, t692).sub_product(t146,
        t690);
    let t695 = (-(t685 * t131)).add_product(t133, t694).add_product(t135, t693).add_product(t137,
        t692).add_product(t139, t690);
    let t696 = (t684 * t120).sub_product(t122, t695).add_product(t124, t694).sub_product(t126, t693)
        .sub_product(t128, t692).sub_product(t130, t690);
    let t697 = (-(t683 * t109)).add_product(t111, t696).sub_product(t112, t695).add_product(t113,
        t694).add_product(t115, t693).add_product(t117, t692).add_product(t119, t690);
    let t698 = (t682 * t98).sub_product(t100, t697).sub_product(t102, t696).sub_product(t104, t693)
        .sub_product(t106, t692).sub_product(t108, t690);
    let t699 = (-(t681 * t85)).add_product(t87, t698).sub_product(t89, t697).add_product(t91, t696)
        .add_product(t93, t693).add_product(t95, t692).add_product(t97, t690);
    let t700 = (t680 * t72).sub_product(t74, t699).sub_product(t76, t698).add_product(t79, t693)
        .sub_product(t82, t692).sub_product(t84, t690);
    let t701 = (-(t678 * t57).add_product(t60, t700).add_product(t62, t699).add_product(t63, t698)
        .add_product(t66, t693)).add_product(t68, t692).add_product(t70, t690);
    let t702 = (t53 * t700).add_product(t51, t701).add_product(t55, t690);
    let t703 = (t43 * t701).sub_product(t41, t702).add_product(t41, t700).sub_product(t45, t690);
    let drum_v_y_dot_by_plate_omega = (t36 * t691).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t691);
    let drum_v_x_dot_by_plate_omega = (t35 * t691).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t691);
    let bobbin_v_y_dot_by_plate_omega = -(t34 * t691).add_product(c.inverse_bobbin_mass, t692);
    let bobbin_v_x_dot_by_plate_omega = -(t33 * t691).add_product(c.inverse_bobbin_mass, t693);
    let rod_omega_dot_by_plate_omega = (t31 * t695).sub_product(R::literal(4_166.666_666_666_667),
        t697).sub_product(t32, t694);
    let rod_v_y_dot_by_plate_omega = (R::literal(-5.0) * t694).sub_product(t30, t696);
    let rod_v_x_dot_by_plate_omega = (R::literal(-5.0) * t695).add_product(t29, t696);
    let cylinder_omega_dot_by_plate_omega = (t27 * t698).sub_product(t26, t699)
        .sub_product(R::literal(-2_777.777_777_777_778), t697).add_product(t28, t696);
    let cylinder_v_y_dot_by_plate_omega = (t25 * t696)
        .sub_product(R::literal(3.333_333_333_333_333_5), t698);
    let cylinder_v_x_dot_by_plate_omega = (-(t24 * t696))
        .add_product(R::literal(-3.333_333_333_333_333_5), t699);
    let plate_omega_dot_by_plate_omega = (t21 * t700).sub_product(t20, t701).sub_product(t20, t699)
        .add_product(t21, t698).add_product(t22, t693).sub_product(t23, t692);
    let plate_v_y_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t698)
        .add_product(R::literal(-0.833_333_333_333_333_4), t700)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t692);
    let plate_v_x_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t699)
        .add_product(R::literal(-0.833_333_333_333_333_4), t701)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t693);
    let post_omega_dot_by_plate_omega = (-(t18 * t702).add_product(t17, t703).add_product(t17,
        t701)).add_product(t18, t700).sub_product(t19, t690);
    let post_v_y_dot_by_plate_omega = (R::literal(1.25) * t700).add_product(R::literal(1.25), t702);
    let post_v_x_dot_by_plate_omega = (R::literal(1.25) * t701).add_product(R::literal(-1.25),
        t703);
    let cos_cylinder_phi_squared = cos_cylinder_phi * cos_cylinder_phi;
    let t704 = R::literal(50.0) * cos_cylinder_phi_squared;
    let t705 = R::literal(50.0) * sin_cylinder_phi * cos_cylinder_phi;
    let t706 = R::literal(50.0) * t12;
    let t707 = t706 * cos_cylinder_phi;
    let t708 = R::literal(2.0) * cylinder_omega;
    let t709 = t708 * cos_cylinder_phi;
    let t710 = R::literal(166.666_666_666_666_69) * cos_cylinder_phi_squared;
    let t711 = t26 * t707;
    let t712 = t710 - t711;
    let t713 = R::literal(3.333_333_333_333_333_5) * t705;
    let t714 = t713.add_product(t27, t707);
    let t715 = t714.add_product(t87, t712);
    let t716 = R::literal(-2_777.777_777_777_778) * t707;
    let t717 = t716.add_product(t89, t712).add_product(t100, t715);
    let t718 = t24 * t704;
    let t719 = t25 * t705;
    let t720 = t28 * t707;
    let t721 = t29 * t704;
    let t722 = t30 * t705;
    let t723 = (t718 - t709 - t719 + t720 + t721 - t722).add_product(t91, t712).sub_product(t102,
        t715).sub_product(t111, t717);
    let t724 = R::literal(250.0) * cos_cylinder_phi_squared;
    let t725 = (-t724).add_product(t112, t717).sub_product(t122, t723);
    let t726 = R::literal(5.0) * t705;
    let t727 = (-t726.add_product(t113, t717)).add_product(t124, t723).add_product(t133, t725);
    let t728 = (t93 * t712).sub_product(t104, t715).sub_product(t115, t717).sub_product(t126, t723)
        .add_product(t135, t725).sub_product(t142, t727);
    let t729 = (t95 * t712).sub_product(t106, t715).sub_product(t117, t717).sub_product(t128, t723)
        .add_product(t137, t725).sub_product(t144, t727).sub_product(t149, t728);
    let t730 = (t150 * t728).sub_product(t155, t729);
    let t731 = t707 * R::literal(2_777.777_777_777_778);
    let t732 = (t97 * t712).sub_product(t108, t715).sub_product(t119, t717).sub_product(t130, t723)
        .add_product(t139, t725).sub_product(t146, t727).sub_product(t152, t728).sub_product(t157,
        t729).sub_product(t162, t730) * t163;
    let t733 = (t730 * t160).sub_product(t162, t732);
    let t734 = (t729 * t153).sub_product(t155, t733).sub_product(t157, t732);
    let t735 = (t728 * t147).sub_product(t149, t734).add_product(t150, t733).sub_product(t152,
        t732);
    let t736 = (t727 * t140).sub_product(t142, t735).sub_product(t144, t734).sub_product(t146,
        t732);
    let t737 = (-(t725 * t131)).add_product(t133, t736).add_product(t135, t735).add_product(t137,
        t734).add_product(t139, t732);
    let t738 = (t723 * t120).sub_product(t122, t737).add_product(t124, t736).sub_product(t126, t735)
        .sub_product(t128, t734).sub_product(t130, t732);
    let t739 = (-(t717 * t109)).add_product(t111, t738).sub_product(t112, t737).add_product(t113,
        t736).add_product(t115, t735).add_product(t117, t734).add_product(t119, t732);
    let t740 = (t715 * t98).sub_product(t100, t739).sub_product(t102, t738).sub_product(t104, t735)
        .sub_product(t106, t734).sub_product(t108, t732);
    let t741 = (-(t712 * t85)).add_product(t87, t740).sub_product(t89, t739).add_product(t91, t738)
        .add_product(t93, t735).add_product(t95, t734).add_product(t97, t732);
    let t742 = (-(t76 * t740).add_product(t74, t741)).add_product(t79, t735).sub_product(t82, t734)
        .sub_product(t84, t732);
    let t743 = (-(t62 * t741).add_product(t60, t742).add_product(t63, t740).add_product(t66, t735))
        .add_product(t68, t734).add_product(t70, t732);
    let t744 = (t53 * t742).add_product(t51, t743).add_product(t55, t732);
    let t745 = (t43 * t743).sub_product(t41, t744).add_product(t41, t742).sub_product(t45, t732);
    let drum_v_y_dot_by_cylinder_v_x = (t36 * t733)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t733);
    let drum_v_x_dot_by_cylinder_v_x = (t35 * t733)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t733);
    let bobbin_v_y_dot_by_cylinder_v_x = -(t34 * t733).add_product(c.inverse_bobbin_mass, t734);
    let bobbin_v_x_dot_by_cylinder_v_x = -(t33 * t733).add_product(c.inverse_bobbin_mass, t735);
    let rod_omega_dot_by_cylinder_v_x = (t31 * t737).sub_product(R::literal(4_166.666_666_666_667),
        t739).sub_product(t32, t736);
    let rod_v_y_dot_by_cylinder_v_x = t726.sub_product(t30, t738).sub_product(R::literal(5.0),
        t736);
    let rod_v_x_dot_by_cylinder_v_x = t724.add_product(t29, t738).sub_product(R::literal(5.0),
        t737);
    let cylinder_omega_dot_by_cylinder_v_x = t731.sub_product(t26, t741).add_product(t27, t740)
        .sub_product(R::literal(-2_777.777_777_777_778), t739).add_product(t28, t738);
    let cylinder_v_y_dot_by_cylinder_v_x = (-t713.add_product(R::literal(3.333_333_333_333_333_5),
        t740)).add_product(t25, t738);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t710)
        .add_product(R::literal(-3.333_333_333_333_333_5), t741).sub_product(t24, t738);
    let plate_omega_dot_by_cylinder_v_x = (t21 * t742).sub_product(t20, t743).sub_product(t20, t741)
        .add_product(t21, t740).add_product(t22, t735).sub_product(t23, t734);
    let plate_v_y_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t740)
        .add_product(R::literal(-0.833_333_333_333_333_4), t742)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t734);
    let plate_v_x_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t741)
        .add_product(R::literal(-0.833_333_333_333_333_4), t743)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t735);
    let post_omega_dot_by_cylinder_v_x = (-(t18 * t744).add_product(t17, t745).add_product(t17,
        t743)).add_product(t18, t742).sub_product(t19, t732);
    let post_v_y_dot_by_cylinder_v_x = (R::literal(1.25) * t742).add_product(R::literal(1.25),
        t744);
    let post_v_x_dot_by_cylinder_v_x = (R::literal(1.25) * t743).add_product(R::literal(-1.25),
        t745);
    let sin_cylinder_phi_squared = sin_cylinder_phi * sin_cylinder_phi;
    let t746 = R::literal(50.0) * sin_cylinder_phi_squared;
    let t747 = t706 * sin_cylinder_phi;
    let t748 = t708 * sin_cylinder_phi;
    let t749 = t26 * t747;
    let t750 = t713 - t749;
    let t751 = R::literal(166.666_666_666_666_69) * sin_cylinder_phi_squared;
    let t752 = t751.add_product(t27, t747);
    let t753 = t752.add_product(t87, t750);
    let t754 = R::literal(-2_777.777_777_777_778) * t747;
    let t755 = t754.add_product(t89, t750).add_product(t100, t753);
    let t756 = t24 * t705;
    let t757 = t25 * t746;
    let t758 = t28 * t747;
    let t759 = t29 * t705;
    let t760 = t30 * t746;
    let t761 = (t756 - t748 - t757 + t758 + t759 - t760).add_product(t91, t750).sub_product(t102,
        t753).sub_product(t111, t755);
    let t762 = (-t726).add_product(t112, t755).sub_product(t122, t761);
    let t763 = R::literal(250.0) * sin_cylinder_phi_squared;
    let t764 = (-t763.add_product(t113, t755)).add_product(t124, t761).add_product(t133, t762);
    let t765 = (t93 * t750).sub_product(t104, t753).sub_product(t115, t755).sub_product(t126, t761)
        .add_product(t135, t762).sub_product(t142, t764);
    let t766 = (t95 * t750).sub_product(t106, t753).sub_product(t117, t755).sub_product(t128, t761)
        .add_product(t137, t762).sub_product(t144, t764).sub_product(t149, t765);
    let t767 = (t150 * t765).sub_product(t155, t766);
    let t768 = t747 * R::literal(2_777.777_777_777_778);
    let t769 = (t97 * t750).sub_product(t108, t753).sub_product(t119, t755).sub_product(t130, t761)
        .add_product(t139, t762).sub_product(t146, t764).sub_product(t152, t765).sub_product(t157,
        t766).sub_product(t162, t767) * t163;
    let t770 = (t767 * t160).sub_product(t162, t769);
    let t771 = (t766 * t153).sub_product(t155, t770).sub_product(t157, t769);
    let t772 = (t765 * t147).sub_product(t149, t771).add_product(t150, t770).sub_product(t152,
        t769);
    let t773 = (t764 * t140).sub_product(t142, t772).sub_product(t144, t771).sub_product(t146,
        t769);
    let t774 = (-(t762 * t131)).add_product(t133, t773).add_product(t135, t772).add_product(t137,
        t771).add_product(t139, t769);
    let t775 = (t761 * t120).sub_product(t122, t774).add_product(t124, t773).sub_product(t126, t772)
        .sub_product(t128, t771).sub_product(t130, t769);
    let t776 = (-(t755 * t109)).add_product(t111, t775).sub_product(t112, t774).add_product(t113,
        t773).add_product(t115, t772).add_product(t117, t771).add_product(t119, t769);
    let t777 = (t753 * t98).sub_product(t100, t776).sub_product(t102, t775).sub_product(t104, t772)
        .sub_product(t106, t771).sub_product(t108, t769);
    let t778 = (-(t750 * t85)).add_product(t87, t777).sub_product(t89, t776).add_product(t91, t775)
        .add_product(t93, t772).add_product(t95, t771).add_product(t97, t769);
    let t779 = (-(t76 * t777).add_product(t74, t778)).add_product(t79, t772).sub_product(t82, t771)
        .sub_product(t84, t769);
    let t780 = (-(t62 * t778).add_product(t60, t779).add_product(t63, t777).add_product(t66, t772))
        .add_product(t68, t771).add_product(t70, t769);
    let t781 = (t53 * t779).add_product(t51, t780).add_product(t55, t769);
    let t782 = (t43 * t780).sub_product(t41, t781).add_product(t41, t779).sub_product(t45, t769);
    let drum_v_y_dot_by_cylinder_v_y = (t36 * t770)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t770);
    let drum_v_x_dot_by_cylinder_v_y = (t35 * t770)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t770);
    let bobbin_v_y_dot_by_cylinder_v_y = -(t34 * t770).add_product(c.inverse_bobbin_mass, t771);
    let bobbin_v_x_dot_by_cylinder_v_y = -(t33 * t770).add_product(c.inverse_bobbin_mass, t772);
    let rod_omega_dot_by_cylinder_v_y = (t31 * t774).sub_product(R::literal(4_166.666_666_666_667),
        t776).sub_product(t32, t773);
    let rod_v_y_dot_by_cylinder_v_y = t763.sub_product(t30, t775).sub_product(R::literal(5.0),
        t773);
    let rod_v_x_dot_by_cylinder_v_y = t726.add_product(t29, t775).sub_product(R::literal(5.0),
        t774);
    let cylinder_omega_dot_by_cylinder_v_y = t768.sub_product(t26, t778).add_product(t27, t777)
        .sub_product(R::literal(-2_777.777_777_777_778), t776).add_product(t28, t775);
    let cylinder_v_y_dot_by_cylinder_v_y = (-t751.add_product(R::literal(3.333_333_333_333_333_5),
        t777)).add_product(t25, t775);
    let cylinder_v_x_dot_by_cylinder_v_y = (-t713)
        .add_product(R::literal(-3.333_333_333_333_333_5), t778).sub_product(t24, t775);
    let plate_omega_dot_by_cylinder_v_y = (t21 * t779).sub_product(t20, t780).sub_product(t20, t778)
        .add_product(t21, t777).add_product(t22, t772).sub_product(t23, t771);
    let plate_v_y_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t777)
        .add_product(R::literal(-0.833_333_333_333_333_4), t779)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t771);
    let plate_v_x_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t778)
        .add_product(R::literal(-0.833_333_333_333_333_4), t780)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t772);
    let post_omega_dot_by_cylinder_v_y = (-(t18 * t781).add_product(t17, t782).add_product(t17,
        t780)).add_product(t18, t779).sub_product(t19, t769);
    let post_v_y_dot_by_cylinder_v_y = (R::literal(1.25) * t779).add_product(R::literal(1.25),
        t781);
    let post_v_x_dot_by_cylinder_v_y = (R::literal(1.25) * t780).add_product(R::literal(-1.25),
        t782);
    let t783 = R::literal(50.0) * t386;
    let t784 = R::literal(0.12) * cylinder_omega;
    let t785 = R::literal(3.333_333_333_333_333_5) * t707;
    let t786 = (-t785.add_product(t784, cos_cylinder_phi)).add_product(t26, t783);
    let t787 = R::literal(3.333_333_333_333_333_5) * t747;
    let t788 = (-t787.add_product(t784, sin_cylinder_phi).add_product(t27, t783)).add_product(t87,
        t786);
    let t789 = (R::literal(-138_888.888_888_888_9) * t386).sub_product(t89, t786).sub_product(t100,
        t788);
    let t790 = (-(t24 * t707)).add_product(R::literal(2.0), ((t191 + t192).add_product(rod_v_x,
        cos_cylinder_phi).add_product(rod_v_y, sin_cylinder_phi) - t187 - t188)
        .sub_product(cylinder_v_x, cos_cylinder_phi).sub_product(cylinder_v_y, sin_cylinder_phi))
        .add_product(t25, t747).sub_product(t28, t783).sub_product(t29, t707).add_product(t30, t747)
        .add_product(t91, t786).sub_product(t102, t788).add_product(t111, t789);
    let t791 = R::literal(5.0) * t707;
    let t792 = t791.sub_product(t112, t789).sub_product(t122, t790);
    let t793 = R::literal(5.0) * t747;
    let t794 = t793.add_product(t113, t789).add_product(t124, t790).add_product(t133, t792);
    let t795 = (t93 * t786).sub_product(t104, t788).add_product(t115, t789).sub_product(t126, t790)
        .add_product(t135, t792).sub_product(t142, t794);
    let t796 = (t95 * t786).sub_product(t106, t788).add_product(t117, t789).sub_product(t128, t790)
        .add_product(t137, t792).sub_product(t144, t794).sub_product(t149, t795);
    let t797 = (t150 * t795).sub_product(t155, t796);
    let t798 = (t97 * t786).sub_product(t108, t788).add_product(t119, t789).sub_product(t130, t790)
        .add_product(t139, t792).sub_product(t146, t794).sub_product(t152, t795).sub_product(t157,
        t796).sub_product(t162, t797) * t163;
    let t799 = (t797 * t160).sub_product(t162, t798);
    let t800 = (t796 * t153).sub_product(t155, t799).sub_product(t157, t798);
    let t801 = (t795 * t147).sub_product(t149, t800).add_product(t150, t799).sub_product(t152,
        t798);
    let t802 = (t794 * t140).sub_product(t142, t801).sub_product(t144, t800).sub_product(t146,
        t798);
    let t803 = (-(t792 * t131)).add_product(t133, t802).add_product(t135, t801).add_product(t137,
        t800).add_product(t139, t798);
    let t804 = (t790 * t120).sub_product(t122, t803).add_product(t124, t802).sub_product(t126, t801)
        .sub_product(t128, t800).sub_product(t130, t798);
    let t805 = (t789 * t109).add_product(t111, t804).sub_product(t112, t803).add_product(t113, t802)
        .add_product(t115, t801).add_product(t117, t800).add_product(t119, t798);
    let t806 = (t788 * t98).sub_product(t100, t805).sub_product(t102, t804).sub_product(t104, t801)
        .sub_product(t106, t800).sub_product(t108, t798);
    let t807 = (-(t786 * t85)).add_product(t87, t806).sub_product(t89, t805).add_product(t91, t804)
        .add_product(t93, t801).add_product(t95, t800).add_product(t97, t798);
    let t808 = (-(t76 * t806).add_product(t74, t807)).add_product(t79, t801).sub_product(t82, t800)
        .sub_product(t84, t798);
    let t809 = (-(t62 * t807).add_product(t60, t808).add_product(t63, t806).add_product(t66, t801))
        .add_product(t68, t800).add_product(t70, t798);
    let t810 = (t53 * t808).add_product(t51, t809).add_product(t55, t798);
    let t811 = (t43 * t809).sub_product(t41, t810).add_product(t41, t808).sub_product(t45, t798);
    let drum_v_y_dot_by_cylinder_omega = (t36 * t799)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t799);
    let drum_v_x_dot_by_cylinder_omega = (t35 * t799)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t799);
    let bobbin_v_y_dot_by_cylinder_omega = -(t34 * t799).add_product(c.inverse_bobbin_mass, t800);
    let bobbin_v_x_dot_by_cylinder_omega = -(t33 * t799).add_product(c.inverse_bobbin_mass, t801);
    let rod_omega_dot_by_cylinder_omega = (t31 * t803)
        .sub_product(R::literal(4_166.666_666_666_667), t805).sub_product(t32, t802);
    let rod_v_y_dot_by_cylinder_omega = (-t793.add_product(t30, t804))
        .add_product(R::literal(-5.0), t802);
    let rod_v_x_dot_by_cylinder_omega = (-t791).add_product(t29, t804).sub_product(R::literal(5.0),
        t803);
    let cylinder_omega_dot_by_cylinder_omega = (-(R::literal(138_888.888_888_888_9) * t386)
        .add_product(t26, t807)).add_product(t27, t806)
        .sub_product(R::literal(-2_777.777_777_777_778), t805).add_product(t28, t804);
    let cylinder_v_y_dot_by_cylinder_omega = t787.sub_product(R::literal(3.333_333_333_333_333_5),
        t806).add_product(t25, t804);
    let cylinder_v_x_dot_by_cylinder_omega = t785.sub_product(R::literal(3.333_333_333_333_333_5),
        t807).sub_product(t24, t804);
    let plate_omega_dot_by_cylinder_omega = (t21 * t808).sub_product(t20, t809).sub_product(t20,
        t807).add_product(t21, t806).add_product(t22, t801).sub_product(t23, t800);
    let plate_v_y_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t806)
        .add_product(R::literal(-0.833_333_333_333_333_4), t808)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t800);
    let plate_v_x_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t807)
        .add_product(R::literal(-0.833_333_333_333_333_4), t809)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t801);
    let post_omega_dot_by_cylinder_omega = (-(t18 * t810).add_product(t17, t811).add_product(t17,
        t809)).add_product(t18, t808).sub_product(t19, t798);
    let post_v_y_dot_by_cylinder_omega = (R::literal(1.25) * t808).add_product(R::literal(1.25),
        t810);
    let post_v_x_dot_by_cylinder_omega = (R::literal(1.25) * t809).add_product(R::literal(-1.25),
        t811);
    let t812 = t711 - t710;
    let t813 = (-t714).add_product(t87, t812);
    let t814 = t716.sub_product(t89, t812).sub_product(t100, t813);
    let t815 = (t709 - t718 + t719 - t720 - t721 + t722).add_product(t91, t812).sub_product(t102,
        t813).add_product(t111, t814);
    let t816 = t724.sub_product(t112, t814).sub_product(t122, t815);
    let t817 = t726.add_product(t113, t814).add_product(t124, t815).add_product(t133, t816);
    let t818 = (t93 * t812).sub_product(t104, t813).add_product(t115, t814).sub_product(t126, t815)
        .add_product(t135, t816).sub_product(t142, t817);
    let t819 = (t95 * t812).sub_product(t106, t813).add_product(t117, t814).sub_product(t128, t815)
        .add_product(t137, t816).sub_product(t144, t817).sub_product(t149, t818);
    let t820 = (t150 * t818).sub_product(t155, t819);
    let t821 = (t97 * t812).sub_product(t108, t813).add_product(t119, t814).sub_product(t130, t815)
        .add_product(t139, t816).sub_product(t146, t817).sub_product(t152, t818).sub_product(t157,
        t819).sub_product(t162, t820) * t163;
    let t822 = (t820 * t160).sub_product(t162, t821);
    let t823 = (t819 * t153).sub_product(t155, t822).sub_product(t157, t821);
    let t824 = (t818 * t147).sub_product(t149, t823).add_product(t150, t822).sub_product(t152,
        t821);
    let t825 = (t817 * t140).sub_product(t142, t824).sub_product(t144, t823).sub_product(t146,
        t821);
    let t826 = (-(t816 * t131)).add_product(t133, t825).add_product(t135, t824).add_product(t137,
        t823).add_product(t139, t821);
    let t827 = (t815 * t120).sub_product(t122, t826).add_product(t124, t825).sub_product(t126, t824)
        .sub_product(t128, t823).sub_product(t130, t821);
    let t828 = (t814 * t109).add_product(t111, t827).sub_product(t112, t826).add_product(t113, t825)
        .add_product(t115, t824).add_product(t117, t823).add_product(t119, t821);
    let t829 = (t813 * t98).sub_product(t100, t828).sub_product(t102, t827).sub_product(t104, t824)
        .sub_product(t106, t823).sub_product(t108, t821);
    let t830 = (-(t812 * t85)).add_product(t87, t829).sub_product(t89, t828).add_product(t91, t827)
        .add_product(t93, t824).add_product(t95, t823).add_product(t97, t821);
    let t831 = (-(t76 * t829).add_product(t74, t830)).add_product(t79, t824).sub_product(t82, t823)
        .sub_product(t84, t821);
    let t832 = (-(t62 * t830).add_product(t60, t831).add_product(t63, t829).add_product(t66, t824))
        .add_product(t68, t823).add_product(t70, t821);
    let t833 = (t53 * t831).add_product(t51, t832).add_product(t55, t821);
    let t834 = (t43 * t832).sub_product(t41, t833).add_product(t41, t831).sub_product(t45, t821);
    let drum_v_y_dot_by_rod_v_x = (t36 * t822).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t822);
    let drum_v_x_dot_by_rod_v_x = (t35 * t822).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t822);
    let bobbin_v_y_dot_by_rod_v_x = -(t34 * t822).add_product(c.inverse_bobbin_mass, t823);
    let bobbin_v_x_dot_by_rod_v_x = -(t33 * t822).add_product(c.inverse_bobbin_mass, t824);
    let rod_omega_dot_by_rod_v_x = (t31 * t826).sub_product(R::literal(4_166.666_666_666_667), t828)
        .sub_product(t32, t825);
    let rod_v_y_dot_by_rod_v_x = (-t726.add_product(t30, t827)).add_product(R::literal(-5.0), t825);
    let rod_v_x_dot_by_rod_v_x = (-t724).add_product(t29, t827).sub_product(R::literal(5.0), t826);
    let cylinder_omega_dot_by_rod_v_x = (-t731.add_product(t26, t830)).add_product(t27, t829)
        .sub_product(R::literal(-2_777.777_777_777_778), t828).add_product(t28, t827);
    let cylinder_v_y_dot_by_rod_v_x = t713.sub_product(R::literal(3.333_333_333_333_333_5), t829)
        .add_product(t25, t827);
    let cylinder_v_x_dot_by_rod_v_x = t710.sub_product(R::literal(3.333_333_333_333_333_5), t830)
        .sub_product(t24, t827);
    let plate_omega_dot_by_rod_v_x = (t21 * t831).sub_product(t20, t832).sub_product(t20, t830)
        .add_product(t21, t829).add_product(t22, t824).sub_product(t23, t823);
    let plate_v_y_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t829)
        .add_product(R::literal(-0.833_333_333_333_333_4), t831)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t823);
    let plate_v_x_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t830)
        .add_product(R::literal(-0.833_333_333_333_333_4), t832)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t824);
    let post_omega_dot_by_rod_v_x = (-(t18 * t833).add_product(t17, t834).add_product(t17, t832))
        .add_product(t18, t831).sub_product(t19, t821);
    let post_v_y_dot_by_rod_v_x = (R::literal(1.25) * t831).add_product(R::literal(1.25), t833);
    let post_v_x_dot_by_rod_v_x = (R::literal(1.25) * t832).add_product(R::literal(-1.25), t834);
    let t835 = t749 - t713;
    let t836 = (-t752).add_product(t87, t835);
    let t837 = t754.sub_product(t89, t835).sub_product(t100, t836);
    let t838 = (t748 - t756 + t757 - t758 - t759 + t760).add_product(t91, t835).sub_product(t102,
        t836).add_product(t111, t837);
    let t839 = t726.sub_product(t112, t837).sub_product(t122, t838);
    let t840 = t763.add_product(t113, t837).add_product(t124, t838).add_product(t133, t839);
    let t841 = (t93 * t835).sub_product(t104, t836).add_product(t115, t837).sub_product(t126, t838)
        .add_product(t135, t839).sub_product(t142, t840);
    let t842 = (t95 * t835).sub_product(t106, t836).add_product(t117, t837).sub_product(t128, t838)
        .add_product(t137, t839).sub_product(t144, t840).sub_product(t149, t841);
    let t843 = (t150 * t841).sub_product(t155, t842);
    let t844 = (t97 * t835).sub_product(t108, t836).add_product(t119, t837).sub_product(t130, t838)
        .add_product(t139, t839).sub_product(t146, t840).sub_product(t152, t841).sub_product(t157,
        t842).sub_product(t162, t843) * t163;
    let t845 = (t843 * t160).sub_product(t162, t844);
    let t846 = (t842 * t153).sub_product(t155, t845).sub_product(t157, t844);
    let t847 = (t841 * t147).sub_product(t149, t846).add_product(t150, t845).sub_product(t152,
        t844);
    let t848 = (t840 * t140).sub_product(t142, t847).sub_product(t144, t846).sub_product(t146,
        t844);
    let t849 = (-(t839 * t131)).add_product(t133, t848).add_product(t135, t847).add_product(t137,
        t846).add_product(t139, t844);
    let t850 = (t838 * t120).sub_product(t122, t849).add_product(t124, t848).sub_product(t126, t847)
        .sub_product(t128, t846).sub_product(t130, t844);
    let t851 = (t837 * t109).add_product(t111, t850).sub_product(t112, t849).add_product(t113, t848)
        .add_product(t115, t847).add_product(t117, t846).add_product(t119, t844);
    let t852 = (t836 * t98).sub_product(t100, t851).sub_product(t102, t850).sub_product(t104, t847)
        .sub_product(t106, t846).sub_product(t108, t844);
    let t853 = (-(t835 * t85)).add_product(t87, t852).sub_product(t89, t851).add_product(t91, t850)
        .add_product(t93, t847).add_product(t95, t846).add_product(t97, t844);
    let t854 = (-(t76 * t852).add_product(t74, t853)).add_product(t79, t847).sub_product(t82, t846)
        .sub_product(t84, t844);
    let t855 = (-(t62 * t853).add_product(t60, t854).add_product(t63, t852).add_product(t66, t847))
        .add_product(t68, t846).add_product(t70, t844);
    let t856 = (t53 * t854).add_product(t51, t855).add_product(t55, t844);
    let t857 = (t43 * t855).sub_product(t41, t856).add_product(t41, t854).sub_product(t45, t844);
    let drum_v_y_dot_by_rod_v_y = (t36 * t845).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t845);
    let drum_v_x_dot_by_rod_v_y = (t35 * t845).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t845);
    let bobbin_v_y_dot_by_rod_v_y = -(t34 * t845).add_product(c.inverse_bobbin_mass, t846);
    let bobbin_v_x_dot_by_rod_v_y = -(t33 * t845).add_product(c.inverse_bobbin_mass, t847);
    let rod_omega_dot_by_rod_v_y = (t31 * t849).sub_product(R::literal(4_166.666_666_666_667), t851)
        .sub_product(t32, t848);
    let rod_v_y_dot_by_rod_v_y = (-t763.add_product(t30, t850)).add_product(R::literal(-5.0), t848);
    let rod_v_x_dot_by_rod_v_y = (-t726).add_product(t29, t850).sub_product(R::literal(5.0), t849);
    let cylinder_omega_dot_by_rod_v_y = (-t768.add_product(t26, t853)).add_product(t27, t852)
        .sub_product(R::literal(-2_777.777_777_777_778), t851).add_product(t28, t850);
    let cylinder_v_y_dot_by_rod_v_y = t751.sub_product(R::literal(3.333_333_333_333_333_5), t852)
        .add_product(t25, t850);
    let cylinder_v_x_dot_by_rod_v_y = t713.sub_product(R::literal(3.333_333_333_333_333_5), t853)
        .sub_product(t24, t850);
    let plate_omega_dot_by_rod_v_y = (t21 * t854).sub_product(t20, t855).sub_product(t20, t853)
        .add_product(t21, t852).add_product(t22, t847).sub_product(t23, t846);
    let plate_v_y_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t852)
        .add_product(R::literal(-0.833_333_333_333_333_4), t854)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t846);
    let plate_v_x_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t853)
        .add_product(R::literal(-0.833_333_333_333_333_4), t855)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t847);
    let post_omega_dot_by_rod_v_y = (-(t18 * t856).add_product(t17, t857).add_product(t17, t855))
        .add_product(t18, t854).sub_product(t19, t844);
    let post_v_y_dot_by_rod_v_y = (R::literal(1.25) * t854).add_product(R::literal(1.25), t856);
    let post_v_x_dot_by_rod_v_y = (R::literal(1.25) * t855).add_product(R::literal(-1.25), t857);
    let t858 = R::literal(0.12) * rod_omega;
    let t859 = t858 * cos_rod_phi;
    let t860 = (t858 * sin_rod_phi).add_product(t133, t859);
    let t861 = (t135 * t859).sub_product(t142, t860);
    let t862 = (t137 * t859).sub_product(t144, t860).sub_product(t149, t861);
    let t863 = (t150 * t861).sub_product(t155, t862);
    let t864 = (t139 * t859).sub_product(t146, t860).sub_product(t152, t861).sub_product(t157, t862)
        .sub_product(t162, t863) * t163;
    let t865 = (t863 * t160).sub_product(t162, t864);
    let t866 = (t862 * t153).sub_product(t155, t865).sub_product(t157, t864);
    let t867 = (t861 * t147).sub_product(t149, t866).add_product(t150, t865).sub_product(t152,
        t864);
    let t868 = (t860 * t140).sub_product(t142, t867).sub_product(t144, t866).sub_product(t146,
        t864);
    let t869 = (-(t859 * t131)).add_product(t133, t868).add_product(t135, t867).add_product(t137,
        t866).add_product(t139, t864);
    let t870 = (t124 * t868).sub_product(t122, t869).sub_product(t126, t867).sub_product(t128, t866)
        .sub_product(t130, t864);
    let t871 = (-(t112 * t869)).add_product(t111, t870).add_product(t113, t868).add_product(t115,
        t867).add_product(t117, t866).add_product(t119, t864);
    let t872 = (t102 * t870).add_product(t100, t871).add_product(t104, t867).add_product(t106, t866)
        .add_product(t108, t864);
    let t873 = (-(t89 * t871).add_product(t87, t872)).add_product(t91, t870).add_product(t93, t867)
        .add_product(t95, t866).add_product(t97, t864);
    let t874 = (t76 * t872).sub_product(t74, t873).add_product(t79, t867).sub_product(t82, t866)
        .sub_product(t84, t864);
    let t875 = (-(t62 * t873).add_product(t60, t874)).add_product(t63, t872).sub_product(t66, t867)
        .add_product(t68, t866).add_product(t70, t864);
    let t876 = (t53 * t874).add_product(t51, t875).add_product(t55, t864);
    let t877 = (t43 * t875).sub_product(t41, t876).add_product(t41, t874).sub_product(t45, t864);
    let drum_v_y_dot_by_rod_omega = (t36 * t865).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t865);
    let drum_v_x_dot_by_rod_omega = (t35 * t865).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t865);
    let bobbin_v_y_dot_by_rod_omega = -(t34 * t865).add_product(c.inverse_bobbin_mass, t866);
    let bobbin_v_x_dot_by_rod_omega = -(t33 * t865).add_product(c.inverse_bobbin_mass, t867);
    let rod_omega_dot_by_rod_omega = (t31 * t869).sub_product(R::literal(4_166.666_666_666_667),
        t871).sub_product(t32, t868);
    let rod_v_y_dot_by_rod_omega = (R::literal(-5.0) * t868).sub_product(t30, t870);
    let rod_v_x_dot_by_rod_omega = (R::literal(-5.0) * t869).add_product(t29, t870);
    let cylinder_omega_dot_by_rod_omega = (-(t27 * t872).add_product(t26, t873)
        .add_product(R::literal(-2_777.777_777_777_778), t871)).add_product(t28, t870);
    let cylinder_v_y_dot_by_rod_omega = (t25 * t870)
        .add_product(R::literal(3.333_333_333_333_333_5), t872);
    let cylinder_v_x_dot_by_rod_omega = (-(t24 * t870))
        .add_product(R::literal(-3.333_333_333_333_333_5), t873);
    let plate_omega_dot_by_rod_omega = (t21 * t874).sub_product(t20, t875).sub_product(t20, t873)
        .sub_product(t21, t872).add_product(t22, t867).sub_product(t23, t866);
    let plate_v_y_dot_by_rod_omega = (R::literal(-0.833_333_333_333_333_4) * t872)
        .sub_product(R::literal(0.833_333_333_333_333_4), t874)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t866);
    let plate_v_x_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t873)
        .add_product(R::literal(-0.833_333_333_333_333_4), t875)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t867);
    let post_omega_dot_by_rod_omega = (-(t18 * t876).add_product(t17, t877).add_product(t17, t875))
        .add_product(t18, t874).sub_product(t19, t864);
    let post_v_y_dot_by_rod_omega = (R::literal(1.25) * t874).add_product(R::literal(1.25), t876);
    let post_v_x_dot_by_rod_omega = (R::literal(1.25) * t875).add_product(R::literal(-1.25), t877);
    let t878 = R::literal(2.0) * bobbin_x * drum_x;
    let bobbin_x_times_bobbin_y = bobbin_x * bobbin_y;
    let bobbin_x_times_drum_y = bobbin_x * drum_y;
    let bobbin_y_times_drum_x = bobbin_y * drum_x;
    let drum_x_times_drum_y = drum_x * drum_y;
    let bobbin_x_squared = bobbin_x * bobbin_x;
    let drum_x_squared = drum_x * drum_x;
    let t879 = R::literal(2.0) * (bobbin_x_times_bobbin_y * bobbin_v_y).add_product(t878, drum_v_x)
        .add_product(bobbin_x_times_drum_y, drum_v_y).add_product(bobbin_y_times_drum_x, drum_v_y)
        .add_product(drum_x_times_drum_y, bobbin_v_y).add_product(bobbin_v_x, bobbin_x_squared)
        .add_product(bobbin_v_x, drum_x_squared).add_product(drum_v_x, between_squared)
        .sub_product(t878, bobbin_v_x).sub_product(bobbin_x_times_bobbin_y, drum_v_y)
        .sub_product(bobbin_x_times_drum_y, bobbin_v_y).sub_product(bobbin_y_times_drum_x,
        bobbin_v_y).sub_product(drum_x_times_drum_y, drum_v_y).sub_product(bobbin_v_x,
        between_squared).sub_product(drum_v_x, bobbin_x_squared).sub_product(drum_v_x,
        drum_x_squared) / between_squared_times_between;
    let t880 = t162 * t879 * t163;
    let t881 = (t879 * t160).add_product(t162, t880);
    let t882 = t155 * t881;
    let t883 = t157 * t880;
    let t884 = t883 - t882;
    let t885 = t150 * t881;
    let t886 = t152 * t880;
    let t887 = t885.sub_product(t149, t884) + t886;
    let t888 = t146 * t880;
    let t889 = t888 - (t144 * t884).add_product(t142, t887);
    let t890 = t139 * t880;
    let t891 = (t135 * t887).add_product(t133, t889).add_product(t137, t884) - t890;
    let t892 = t130 * t880;
    let t893 = (t124 * t889).sub_product(t122, t891).sub_product(t126, t887).sub_product(t128,
        t884) + t892;
    let t894 = t119 * t880;
    let t895 = (-(t112 * t891)).add_product(t111, t893).add_product(t113, t889).add_product(t115,
        t887).add_product(t117, t884) - t894;
    let t896 = t108 * t880;
    let t897 = t896 - (t102 * t893).add_product(t100, t895).add_product(t104, t887)
        .add_product(t106, t884);
    let t898 = t97 * t880;
    let t899 = (-(t89 * t895)).add_product(t87, t897).add_product(t91, t893).add_product(t93, t887)
        .add_product(t95, t884) - t898;
    let t900 = t84 * t880;
    let t901 = (-(t76 * t897).add_product(t74, t899)).add_product(t79, t887).sub_product(t82, t884)
        + t900;
    let t902 = t70 * t880;
    let t903 = (-(t62 * t899).add_product(t60, t901).add_product(t63, t897).add_product(t66, t887))
        .add_product(t68, t884) - t902;
    let t904 = t55 * t880;
    let t905 = t904 - (t53 * t901).add_product(t51, t903);
    let t906 = t45 * t880;
    let t907 = (t43 * t903).add_product(t41, t905).add_product(t41, t901) + t906;
    let t908 = R::literal(0.666_666_666_666_666_6) * (bobbin_y_minus_drum_y_over_between * t881);
    let t909 = t36 * t881;
    let drum_v_y_dot_by_bobbin_v_x = t909 - t908;
    let t910 = R::literal(0.666_666_666_666_666_6) * (bobbin_x_minus_drum_x_over_between * t881);
    let t911 = t35 * t881;
    let drum_v_x_dot_by_bobbin_v_x = t911 - t910;
    let t912 = t34 * t881;
    let bobbin_v_y_dot_by_bobbin_v_x = -t912.add_product(c.inverse_bobbin_mass, t884);
    let t913 = t33 * t881;
    let bobbin_v_x_dot_by_bobbin_v_x = -t913.add_product(c.inverse_bobbin_mass, t887);
    let rod_omega_dot_by_bobbin_v_x = (t31 * t891).sub_product(R::literal(4_166.666_666_666_667),
        t895).sub_product(t32, t889);
    let rod_v_y_dot_by_bobbin_v_x = (R::literal(-5.0) * t889).sub_product(t30, t893);
    let rod_v_x_dot_by_bobbin_v_x = (R::literal(-5.0) * t891).add_product(t29, t893);
    let cylinder_omega_dot_by_bobbin_v_x = (t27 * t897).sub_product(t26, t899)
        .sub_product(R::literal(-2_777.777_777_777_778), t895).add_product(t28, t893);
    let cylinder_v_y_dot_by_bobbin_v_x = (t25 * t893)
        .sub_product(R::literal(3.333_333_333_333_333_5), t897);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(t24 * t893))
        .add_product(R::literal(-3.333_333_333_333_333_5), t899);
    let plate_omega_dot_by_bobbin_v_x = (t21 * t901).sub_product(t20, t903).sub_product(t20, t899)
        .add_product(t21, t897).add_product(t22, t887).sub_product(t23, t884);
    let plate_v_y_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t897)
        .add_product(R::literal(-0.833_333_333_333_333_4), t901)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t884);
    let plate_v_x_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t899)
        .add_product(R::literal(-0.833_333_333_333_333_4), t903)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t887);
    let t914 = t19 * t880;
    let post_omega_dot_by_bobbin_v_x = (t18 * t905).sub_product(t17, t907).sub_product(t17, t903)
        .add_product(t18, t901) + t914;
    let post_v_y_dot_by_bobbin_v_x = (R::literal(1.25) * t901).add_product(R::literal(-1.25), t905);
    let post_v_x_dot_by_bobbin_v_x = (R::literal(1.25) * t903).add_product(R::literal(-1.25), t907);
    let t915 = R::literal(2.0) * bobbin_y * drum_y;
    let bobbin_y_squared = bobbin_y * bobbin_y;
    let drum_y_squared = drum_y * drum_y;
    let t916 = R::literal(2.0) * (bobbin_x_times_bobbin_y * bobbin_v_x).add_product(t915, drum_v_y)
        .add_product(bobbin_x_times_drum_y, drum_v_x).add_product(bobbin_y_times_drum_x, drum_v_x)
        .add_product(drum_x_times_drum_y, bobbin_v_x).add_product(bobbin_v_y, bobbin_y_squared)
        .add_product(bobbin_v_y, drum_y_squared).add_product(drum_v_y, between_squared)
        .sub_product(t915, bobbin_v_y).sub_product(bobbin_x_times_bobbin_y, drum_v_x)
        .sub_product(bobbin_x_times_drum_y, bobbin_v_x).sub_product(bobbin_y_times_drum_x,
        bobbin_v_x).sub_product(drum_x_times_drum_y, drum_v_x).sub_product(bobbin_v_y,
        between_squared).sub_product(drum_v_y, bobbin_y_squared).sub_product(drum_v_y,
        drum_y_squared) / between_squared_times_between;
    let t917 = t162 * t916 * t163;
    let t918 = (t916 * t160).add_product(t162, t917);
    let t919 = t155 * t918;
    let t920 = t157 * t917;
    let t921 = t920 - t919;
    let t922 = t150 * t918;
    let t923 = t152 * t917;
    let t924 = t922.sub_product(t149, t921) + t923;
    let t925 = t146 * t917;
    let t926 = t925 - (t144 * t921).add_product(t142, t924);
    let t927 = t139 * t917;
    let t928 = (t135 * t924).add_product(t133, t926).add_product(t137, t921) - t927;
    let t929 = t130 * t917;
    let t930 = (t124 * t926).sub_product(t122, t928).sub_product(t126, t924).sub_product(t128,
        t921) + t929;
    let t931 = t119 * t917;
    let t932 = (-(t112 * t928)).add_product(t111, t930).add_product(t113, t926).add_product(t115,
        t924).add_product(t117, t921) - t931;
    let t933 = t108 * t917;
    let t934 = t933 - (t102 * t930).add_product(t100, t932).add_product(t104, t924)
        .add_product(t106, t921);
    let t935 = t97 * t917;
    let t936 = (-(t89 * t932)).add_product(t87, t934).add_product(t91, t930).add_product(t93, t924)
        .add_product(t95, t921) - t935;
    let t937 = t84 * t917;
    let t938 = (-(t76 * t934).add_product(t74, t936)).add_product(t79, t924).sub_product(t82, t921)
        + t937;
    let t939 = t70 * t917;
    let t940 = (-(t62 * t936).add_product(t60, t938).add_product(t63, t934).add_product(t66, t924))
        .add_product(t68, t921) - t939;
    let t941 = t55 * t917;
    let t942 = t941 - (t53 * t938).add_product(t51, t940);
    let t943 = t45 * t917;
    let t944 = (t43 * t940).add_product(t41, t942).add_product(t41, t938) + t943;
    let t945 = R::literal(0.666_666_666_666_666_6) * (bobbin_y_minus_drum_y_over_between * t918);
    let t946 = t36 * t918;
    let drum_v_y_dot_by_bobbin_v_y = t946 - t945;
    let t947 = R::literal(0.666_666_666_666_666_6) * (bobbin_x_minus_drum_x_over_between * t918);
    let t948 = t35 * t918;
    let drum_v_x_dot_by_bobbin_v_y = t948 - t947;
    let t949 = t34 * t918;
    let bobbin_v_y_dot_by_bobbin_v_y = -t949.add_product(c.inverse_bobbin_mass, t921);
    let t950 = t33 * t918;
    let bobbin_v_x_dot_by_bobbin_v_y = -t950.add_product(c.inverse_bobbin_mass, t924);
    let rod_omega_dot_by_bobbin_v_y = (t31 * t928).sub_product(R::literal(4_166.666_666_666_667),
        t932).sub_product(t32, t926);
    let rod_v_y_dot_by_bobbin_v_y = (R::literal(-5.0) * t926).sub_product(t30, t930);
    let rod_v_x_dot_by_bobbin_v_y = (R::literal(-5.0) * t928).add_product(t29, t930);
    let cylinder_omega_dot_by_bobbin_v_y = (t27 * t934).sub_product(t26, t936)
        .sub_product(R::literal(-2_777.777_777_777_778), t932).add_product(t28, t930);
    let cylinder_v_y_dot_by_bobbin_v_y = (t25 * t930)
        .sub_product(R::literal(3.333_333_333_333_333_5), t934);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(t24 * t930))
        .add_product(R::literal(-3.333_333_333_333_333_5), t936);
    let plate_omega_dot_by_bobbin_v_y = (t21 * t938).sub_product(t20, t940).sub_product(t20, t936)
        .add_product(t21, t934).add_product(t22, t924).sub_product(t23, t921);
    let plate_v_y_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t934)
        .add_product(R::literal(-0.833_333_333_333_333_4), t938)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t921);
    let plate_v_x_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t936)
        .add_product(R::literal(-0.833_333_333_333_333_4), t940)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t924);
    let t951 = t19 * t917;
    let post_omega_dot_by_bobbin_v_y = (t18 * t942).sub_product(t17, t944).sub_product(t17, t940)
        .add_product(t18, t938) + t951;
    let post_v_y_dot_by_bobbin_v_y = (R::literal(1.25) * t938).add_product(R::literal(-1.25), t942);
    let post_v_x_dot_by_bobbin_v_y = (R::literal(1.25) * t940).add_product(R::literal(-1.25), t944);
    let t952 = t882 - t883;
    let t953 = t885.add_product(t149, t952) + t886;
    let t954 = (-(t144 * t952)).add_product(t142, t953) - t888;
    let t955 = (-(t135 * t953)).add_product(t133, t954).add_product(t137, t952) + t890;
    let t956 = (t124 * t954).sub_product(t122, t955).add_product(t126, t953).sub_product(t128,
        t952) - t892;
    let t957 = (-(t112 * t955)).add_product(t111, t956).add_product(t113, t954).sub_product(t115,
        t953).add_product(t117, t952) + t894;
    let t958 = (-(t102 * t956).add_product(t100, t957)).add_product(t104, t953).sub_product(t106,
        t952) - t896;
    let t959 = (-(t89 * t957)).add_product(t87, t958).add_product(t91, t956).sub_product(t93, t953)
        .add_product(t95, t952) + t898;
    let t960 = (t76 * t958).add_product(t74, t959).add_product(t79, t953).add_product(t82, t952)
        + t900;
    let t961 = (-(t62 * t959)).add_product(t60, t960).sub_product(t63, t958).add_product(t66, t953)
        .add_product(t68, t952) + t902;
    let t962 = (t53 * t960).sub_product(t51, t961) - t904;
    let t963 = (t43 * t961).add_product(t41, t962).sub_product(t41, t960) - t906;
    let drum_v_y_dot_by_drum_v_x = t908 - t909;
    let drum_v_x_dot_by_drum_v_x = t910 - t911;
    let bobbin_v_y_dot_by_drum_v_x = t912.sub_product(c.inverse_bobbin_mass, t952);
    let bobbin_v_x_dot_by_drum_v_x = t913.add_product(c.inverse_bobbin_mass, t953);
    let rod_omega_dot_by_drum_v_x = (t31 * t955).sub_product(R::literal(4_166.666_666_666_667),
        t957).sub_product(t32, t954);
    let rod_v_y_dot_by_drum_v_x = (R::literal(-5.0) * t954).sub_product(t30, t956);
    let rod_v_x_dot_by_drum_v_x = (R::literal(-5.0) * t955).add_product(t29, t956);
    let cylinder_omega_dot_by_drum_v_x = (t27 * t958).sub_product(t26, t959)
        .sub_product(R::literal(-2_777.777_777_777_778), t957).add_product(t28, t956);
    let cylinder_v_y_dot_by_drum_v_x = (t25 * t956)
        .sub_product(R::literal(3.333_333_333_333_333_5), t958);
    let cylinder_v_x_dot_by_drum_v_x = (-(t24 * t956))
        .add_product(R::literal(-3.333_333_333_333_333_5), t959);
    let plate_omega_dot_by_drum_v_x = (-(t21 * t960).add_product(t20, t961).add_product(t20, t959))
        .add_product(t21, t958).sub_product(t22, t953).sub_product(t23, t952);
    let plate_v_y_dot_by_drum_v_x = (R::literal(0.833_333_333_333_333_4) * t958)
        .add_product(R::literal(0.833_333_333_333_333_4), t960)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t952);
    let plate_v_x_dot_by_drum_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t959)
        .add_product(R::literal(0.833_333_333_333_333_4), t961))
        .add_product(R::literal(-0.833_333_333_333_333_4), t953);
    let post_omega_dot_by_drum_v_x = (t18 * t962).sub_product(t17, t963).sub_product(t17, t961)
        .sub_product(t18, t960) - t914;
    let post_v_y_dot_by_drum_v_x = (R::literal(-1.25) * t960).sub_product(R::literal(1.25), t962);
    let post_v_x_dot_by_drum_v_x = (R::literal(1.25) * t961).add_product(R::literal(-1.25), t963);
    let t964 = t919 - t920;
    let t965 = t922.add_product(t149, t964) + t923;
    let t966 = (-(t144 * t964)).add_product(t142, t965) - t925;
    let t967 = (-(t135 * t965)).add_product(t133, t966).add_product(t137, t964) + t927;
    let t968 = (t124 * t966).sub_product(t122, t967).add_product(t126, t965).sub_product(t128,
        t964) - t929;
    let t969 = (-(t112 * t967)).add_product(t111, t968).add_product(t113, t966).sub_product(t115,
        t965).add_product(t117, t964) + t931;
    let t970 = (-(t102 * t968).add_product(t100, t969)).add_product(t104, t965).sub_product(t106,
        t964) - t933;
    let t971 = (-(t89 * t969)).add_product(t87, t970).add_product(t91, t968).sub_product(t93, t965)
        .add_product(t95, t964) + t935;
    let t972 = (t76 * t970).add_product(t74, t971).add_product(t79, t965).add_product(t82, t964)
        + t937;
    let t973 = (-(t62 * t971)).add_product(t60, t972).sub_product(t63, t970).add_product(t66, t965)
        .add_product(t68, t964) + t939;
    let t974 = (t53 * t972).sub_product(t51, t973) - t941;
    let t975 = (t43 * t973).add_product(t41, t974).sub_product(t41, t972) - t943;
    let drum_v_y_dot_by_drum_v_y = t945 - t946;
    let drum_v_x_dot_by_drum_v_y = t947 - t948;
    let bobbin_v_y_dot_by_drum_v_y = t949.sub_product(c.inverse_bobbin_mass, t964);
    let bobbin_v_x_dot_by_drum_v_y = t950.add_product(c.inverse_bobbin_mass, t965);
    let rod_omega_dot_by_drum_v_y = (t31 * t967).sub_product(R::literal(4_166.666_666_666_667),
        t969).sub_product(t32, t966);
    let rod_v_y_dot_by_drum_v_y = (R::literal(-5.0) * t966).sub_product(t30, t968);
    let rod_v_x_dot_by_drum_v_y = (R::literal(-5.0) * t967).add_product(t29, t968);
    let cylinder_omega_dot_by_drum_v_y = (t27 * t970).sub_product(t26, t971)
        .sub_product(R::literal(-2_777.777_777_777_778), t969).add_product(t28, t968);
    let cylinder_v_y_dot_by_drum_v_y = (t25 * t968)
        .sub_product(R::literal(3.333_333_333_333_333_5), t970);
    let cylinder_v_x_dot_by_drum_v_y = (-(t24 * t968))
        .add_product(R::literal(-3.333_333_333_333_333_5), t971);
    let plate_omega_dot_by_drum_v_y = (-(t21 * t972).add_product(t20, t973).add_product(t20, t971))
        .add_product(t21, t970).sub_product(t22, t965).sub_product(t23, t964);
    let plate_v_y_dot_by_drum_v_y = (R::literal(0.833_333_333_333_333_4) * t970)
        .add_product(R::literal(0.833_333_333_333_333_4), t972)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t964);
    let plate_v_x_dot_by_drum_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t971)
        .add_product(R::literal(0.833_333_333_333_333_4), t973))
        .add_product(R::literal(-0.833_333_333_333_333_4), t965);
    let post_omega_dot_by_drum_v_y = (t18 * t974).sub_product(t17, t975).sub_product(t17, t973)
        .sub_product(t18, t972) - t951;
    let post_v_y_dot_by_drum_v_y = (R::literal(-1.25) * t972).sub_product(R::literal(1.25), t974);
    let post_v_x_dot_by_drum_v_y = (R::literal(1.25) * t973).add_product(R::literal(-1.25), t975);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), post_v_x_dot_by_post_phi,
        post_v_x_dot_by_plate_phi, post_v_x_dot_by_cylinder_x, post_v_x_dot_by_cylinder_y,
        post_v_x_dot_by_cylinder_phi, post_v_x_dot_by_rod_x, post_v_x_dot_by_rod_y,
        post_v_x_dot_by_rod_phi, post_v_x_dot_by_bobbin_x, post_v_x_dot_by_bobbin_y,
        post_v_x_dot_by_drum_x, post_v_x_dot_by_drum_y, post_v_x_dot_by_post_omega,
        post_v_x_dot_by_plate_omega, post_v_x_dot_by_cylinder_v_x, post_v_x_dot_by_cylinder_v_y,
        post_v_x_dot_by_cylinder_omega, post_v_x_dot_by_rod_v_x, post_v_x_dot_by_rod_v_y,
        post_v_x_dot_by_rod_omega, post_v_x_dot_by_bobbin_v_x, post_v_x_dot_by_bobbin_v_y,
        post_v_x_dot_by_drum_v_x, post_v_x_dot_by_drum_v_y, post_v_y_dot_by_post_phi,
        post_v_y_dot_by_plate_phi, post_v_y_dot_by_cylinder_x, post_v_y_dot_by_cylinder_y,
        post_v_y_dot_by_cylinder_phi, post_v_y_dot_by_rod_x, post_v_y_dot_by_rod_y,
        post_v_y_dot_by_rod_phi, post_v_y_dot_by_bobbin_x, post_v_y_dot_by_bobbin_y,
        post_v_y_dot_by_drum_x, post_v_y_dot_by_drum_y, post_v_y_dot_by_post_omega,
        post_v_y_dot_by_plate_omega, post_v_y_dot_by_cylinder_v_x, post_v_y_dot_by_cylinder_v_y,
        post_v_y_dot_by_cylinder_omega, post_v_y_dot_by_rod_v_x, post_v_y_dot_by_rod_v_y,
        post_v_y_dot_by_rod_omega, post_v_y_dot_by_bobbin_v_x, post_v_y_dot_by_bobbin_v_y,
        post_v_y_dot_by_drum_v_x, post_v_y_dot_by_drum_v_y, post_omega_dot_by_post_phi,
        post_omega_dot_by_plate_phi, post_omega_dot_by_cylinder_x, post_omega_dot_by_cylinder_y,
        post_omega_dot_by_cylinder_phi, post_omega_dot_by_rod_x, post_omega_dot_by_rod_y,
        post_omega_dot_by_rod_phi, post_omega_dot_by_bobbin_x, post_omega_dot_by_bobbin_y,
        post_omega_dot_by_drum_x, post_omega_dot_by_drum_y, post_omega_dot_by_post_omega,
        post_omega_dot_by_plate_omega, post_omega_dot_by_cylinder_v_x,
        post_omega_dot_by_cylinder_v_y, post_omega_dot_by_cylinder_omega,
        post_omega_dot_by_rod_v_x, post_omega_dot_by_rod_v_y, post_omega_dot_by_rod_omega,
        post_omega_dot_by_bobbin_v_x, post_omega_dot_by_bobbin_v_y, post_omega_dot_by_drum_v_x,
        post_omega_dot_by_drum_v_y, plate_v_x_dot_by_post_phi, plate_v_x_dot_by_plate_phi,
        plate_v_x_dot_by_cylinder_x, plate_v_x_dot_by_cylinder_y, plate_v_x_dot_by_cylinder_phi,
        plate_v_x_dot_by_rod_x, plate_v_x_dot_by_rod_y, plate_v_x_dot_by_rod_phi,
        plate_v_x_dot_by_bobbin_x, plate_v_x_dot_by_bobbin_y, plate_v_x_dot_by_drum_x,
        plate_v_x_dot_by_drum_y, plate_v_x_dot_by_post_omega, plate_v_x_dot_by_plate_omega,
        plate_v_x_dot_by_cylinder_v_x, plate_v_x_dot_by_cylinder_v_y,
        plate_v_x_dot_by_cylinder_omega, plate_v_x_dot_by_rod_v_x, plate_v_x_dot_by_rod_v_y,
        plate_v_x_dot_by_rod_omega, plate_v_x_dot_by_bobbin_v_x, plate_v_x_dot_by_bobbin_v_y,
        plate_v_x_dot_by_drum_v_x, plate_v_x_dot_by_drum_v_y, plate_v_y_dot_by_post_phi,
        plate_v_y_dot_by_plate_phi, plate_v_y_dot_by_cylinder_x, plate_v_y_dot_by_cylinder_y,
        plate_v_y_dot_by_cylinder_phi, plate_v_y_dot_by_rod_x, plate_v_y_dot_by_rod_y,
        plate_v_y_dot_by_rod_phi, plate_v_y_dot_by_bobbin_x, plate_v_y_dot_by_bobbin_y,
        plate_v_y_dot_by_drum_x, plate_v_y_dot_by_drum_y, plate_v_y_dot_by_post_omega,
        plate_v_y_dot_by_plate_omega, plate_v_y_dot_by_cylinder_v_x, plate_v_y_dot_by_cylinder_v_y,
        plate_v_y_dot_by_cylinder_omega, plate_v_y_dot_by_rod_v_x, plate_v_y_dot_by_rod_v_y,
        plate_v_y_dot_by_rod_omega, plate_v_y_dot_by_bobbin_v_x, plate_v_y_dot_by_bobbin_v_y,
        plate_v_y_dot_by_drum_v_x, plate_v_y_dot_by_drum_v_y, plate_omega_dot_by_post_phi,
        plate_omega_dot_by_plate_phi, plate_omega_dot_by_cylinder_x, plate_omega_dot_by_cylinder_y,
        plate_omega_dot_by_cylinder_phi, plate_omega_dot_by_rod_x, plate_omega_dot_by_rod_y,
        plate_omega_dot_by_rod_phi, plate_omega_dot_by_bobbin_x, plate_omega_dot_by_bobbin_y,
        plate_omega_dot_by_drum_x, plate_omega_dot_by_drum_y, plate_omega_dot_by_post_omega,
        plate_omega_dot_by_plate_omega, plate_omega_dot_by_cylinder_v_x,
        plate_omega_dot_by_cylinder_v_y, plate_omega_dot_by_cylinder_omega,
        plate_omega_dot_by_rod_v_x, plate_omega_dot_by_rod_v_y, plate_omega_dot_by_rod_omega,
        plate_omega_dot_by_bobbin_v_x, plate_omega_dot_by_bobbin_v_y, plate_omega_dot_by_drum_v_x,
        plate_omega_dot_by_drum_v_y, cylinder_v_x_dot_by_post_phi, cylinder_v_x_dot_by_plate_phi,
        cylinder_v_x_dot_by_cylinder_x, cylinder_v_x_dot_by_cylinder_y,
        cylinder_v_x_dot_by_cylinder_phi, cylinder_v_x_dot_by_rod_x, cylinder_v_x_dot_by_rod_y,
        cylinder_v_x_dot_by_rod_phi, cylinder_v_x_dot_by_bobbin_x, cylinder_v_x_dot_by_bobbin_y,
        cylinder_v_x_dot_by_drum_x, cylinder_v_x_dot_by_drum_y, cylinder_v_x_dot_by_post_omega,
        cylinder_v_x_dot_by_plate_omega, cylinder_v_x_dot_by_cylinder_v_x,
        cylinder_v_x_dot_by_cylinder_v_y, cylinder_v_x_dot_by_cylinder_omega,
        cylinder_v_x_dot_by_rod_v_x, cylinder_v_x_dot_by_rod_v_y, cylinder_v_x_dot_by_rod_omega,
        cylinder_v_x_dot_by_bobbin_v_x, cylinder_v_x_dot_by_bobbin_v_y,
        cylinder_v_x_dot_by_drum_v_x, cylinder_v_x_dot_by_drum_v_y, cylinder_v_y_dot_by_post_phi,
        cylinder_v_y_dot_by_plate_phi, cylinder_v_y_dot_by_cylinder_x,
        cylinder_v_y_dot_by_cylinder_y, cylinder_v_y_dot_by_cylinder_phi,
        cylinder_v_y_dot_by_rod_x, cylinder_v_y_dot_by_rod_y, cylinder_v_y_dot_by_rod_phi,
        cylinder_v_y_dot_by_bobbin_x, cylinder_v_y_dot_by_bobbin_y, cylinder_v_y_dot_by_drum_x,
        cylinder_v_y_dot_by_drum_y, cylinder_v_y_dot_by_post_omega,
        cylinder_v_y_dot_by_plate_omega, cylinder_v_y_dot_by_cylinder_v_x,
        cylinder_v_y_dot_by_cylinder_v_y, cylinder_v_y_dot_by_cylinder_omega,
        cylinder_v_y_dot_by_rod_v_x, cylinder_v_y_dot_by_rod_v_y, cylinder_v_y_dot_by_rod_omega,
        cylinder_v_y_dot_by_bobbin_v_x, cylinder_v_y_dot_by_bobbin_v_y,
        cylinder_v_y_dot_by_drum_v_x, cylinder_v_y_dot_by_drum_v_y, cylinder_omega_dot_by_post_phi,
        cylinder_omega_dot_by_plate_phi, cylinder_omega_dot_by_cylinder_x,
        cylinder_omega_dot_by_cylinder_y, cylinder_omega_dot_by_cylinder_phi,
        cylinder_omega_dot_by_rod_x, cylinder_omega_dot_by_rod_y, cylinder_omega_dot_by_rod_phi,
        cylinder_omega_dot_by_bobbin_x, cylinder_omega_dot_by_bobbin_y,
        cylinder_omega_dot_by_drum_x, cylinder_omega_dot_by_drum_y,
        cylinder_omega_dot_by_post_omega, cylinder_omega_dot_by_plate_omega,
        cylinder_omega_dot_by_cylinder_v_x, cylinder_omega_dot_by_cylinder_v_y,
        cylinder_omega_dot_by_cylinder_omega, cylinder_omega_dot_by_rod_v_x,
        cylinder_omega_dot_by_rod_v_y, cylinder_omega_dot_by_rod_omega,
        cylinder_omega_dot_by_bobbin_v_x, cylinder_omega_dot_by_bobbin_v_y,
        cylinder_omega_dot_by_drum_v_x, cylinder_omega_dot_by_drum_v_y, rod_v_x_dot_by_post_phi,
        rod_v_x_dot_by_plate_phi, rod_v_x_dot_by_cylinder_x, rod_v_x_dot_by_cylinder_y,
        rod_v_x_dot_by_cylinder_phi, rod_v_x_dot_by_rod_x, rod_v_x_dot_by_rod_y,
        rod_v_x_dot_by_rod_phi, rod_v_x_dot_by_bobbin_x, rod_v_x_dot_by_bobbin_y,
        rod_v_x_dot_by_drum_x, rod_v_x_dot_by_drum_y, rod_v_x_dot_by_post_omega,
        rod_v_x_dot_by_plate_omega, rod_v_x_dot_by_cylinder_v_x, rod_v_x_dot_by_cylinder_v_y,
        rod_v_x_dot_by_cylinder_omega, rod_v_x_dot_by_rod_v_x, rod_v_x_dot_by_rod_v_y,
        rod_v_x_dot_by_rod_omega, rod_v_x_dot_by_bobbin_v_x, rod_v_x_dot_by_bobbin_v_y,
        rod_v_x_dot_by_drum_v_x, rod_v_x_dot_by_drum_v_y, rod_v_y_dot_by_post_phi,
        rod_v_y_dot_by_plate_phi, rod_v_y_dot_by_cylinder_x, rod_v_y_dot_by_cylinder_y,
        rod_v_y_dot_by_cylinder_phi, rod_v_y_dot_by_rod_x, rod_v_y_dot_by_rod_y,
        rod_v_y_dot_by_rod_phi, rod_v_y_dot_by_bobbin_x, rod_v_y_dot_by_bobbin_y,
        rod_v_y_dot_by_drum_x, rod_v_y_dot_by_drum_y, rod_v_y_dot_by_post_omega,
        rod_v_y_dot_by_plate_omega, rod_v_y_dot_by_cylinder_v_x, rod_v_y_dot_by_cylinder_v_y,
        rod_v_y_dot_by_cylinder_omega, rod_v_y_dot_by_rod_v_x, rod_v_y_dot_by_rod_v_y,
        rod_v_y_dot_by_rod_omega, rod_v_y_dot_by_bobbin_v_x, rod_v_y_dot_by_bobbin_v_y,
        rod_v_y_dot_by_drum_v_x, rod_v_y_dot_by_drum_v_y, rod_omega_dot_by_post_phi,
        rod_omega_dot_by_plate_phi, rod_omega_dot_by_cylinder_x, rod_omega_dot_by_cylinder_y,
        rod_omega_dot_by_cylinder_phi, rod_omega_dot_by_rod_x, rod_omega_dot_by_rod_y,
        rod_omega_dot_by_rod_phi, rod_omega_dot_by_bobbin_x, rod_omega_dot_by_bobbin_y,
        rod_omega_dot_by_drum_x, rod_omega_dot_by_drum_y, rod_omega_dot_by_post_omega,
        rod_omega_dot_by_plate_omega, rod_omega_dot_by_cylinder_v_x, rod_omega_dot_by_cylinder_v_y,
        rod_omega_dot_by_cylinder_omega, rod_omega_dot_by_rod_v_x, rod_omega_dot_by_rod_v_y,
        rod_omega_dot_by_rod_omega, rod_omega_dot_by_bobbin_v_x, rod_omega_dot_by_bobbin_v_y,
        rod_omega_dot_by_drum_v_x, rod_omega_dot_by_drum_v_y, bobbin_v_x_dot_by_post_phi,
        bobbin_v_x_dot_by_plate_phi, bobbin_v_x_dot_by_cylinder_x, bobbin_v_x_dot_by_cylinder_y,
        bobbin_v_x_dot_by_cylinder_phi, bobbin_v_x_dot_by_rod_x, bobbin_v_x_dot_by_rod_y,
        bobbin_v_x_dot_by_rod_phi, bobbin_v_x_dot_by_bobbin_x, bobbin_v_x_dot_by_bobbin_y,
        bobbin_v_x_dot_by_drum_x, bobbin_v_x_dot_by_drum_y, bobbin_v_x_dot_by_post_omega,
        bobbin_v_x_dot_by_plate_omega, bobbin_v_x_dot_by_cylinder_v_x,
        bobbin_v_x_dot_by_cylinder_v_y, bobbin_v_x_dot_by_cylinder_omega,
        bobbin_v_x_dot_by_rod_v_x, bobbin_v_x_dot_by_rod_v_y, bobbin_v_x_dot_by_rod_omega,
        bobbin_v_x_dot_by_bobbin_v_x, bobbin_v_x_dot_by_bobbin_v_y, bobbin_v_x_dot_by_drum_v_x,
        bobbin_v_x_dot_by_drum_v_y, bobbin_v_y_dot_by_post_phi, bobbin_v_y_dot_by_plate_phi,
        bobbin_v_y_dot_by_cylinder_x, bobbin_v_y_dot_by_cylinder_y, bobbin_v_y_dot_by_cylinder_phi,
        bobbin_v_y_dot_by_rod_x, bobbin_v_y_dot_by_rod_y, bobbin_v_y_dot_by_rod_phi,
        bobbin_v_y_dot_by_bobbin_x, bobbin_v_y_dot_by_bobbin_y, bobbin_v_y_dot_by_drum_x,
        bobbin_v_y_dot_by_drum_y, bobbin_v_y_dot_by_post_omega, bobbin_v_y_dot_by_plate_omega,
        bobbin_v_y_dot_by_cylinder_v_x, bobbin_v_y_dot_by_cylinder_v_y,
        bobbin_v_y_dot_by_cylinder_omega, bobbin_v_y_dot_by_rod_v_x, bobbin_v_y_dot_by_rod_v_y,
        bobbin_v_y_dot_by_rod_omega, bobbin_v_y_dot_by_bobbin_v_x, bobbin_v_y_dot_by_bobbin_v_y,
        bobbin_v_y_dot_by_drum_v_x, bobbin_v_y_dot_by_drum_v_y, drum_v_x_dot_by_post_phi,
        drum_v_x_dot_by_plate_phi, drum_v_x_dot_by_cylinder_x, drum_v_x_dot_by_cylinder_y,
        drum_v_x_dot_by_cylinder_phi, drum_v_x_dot_by_rod_x, drum_v_x_dot_by_rod_y,
        drum_v_x_dot_by_rod_phi, drum_v_x_dot_by_bobbin_x, drum_v_x_dot_by_bobbin_y,
        drum_v_x_dot_by_drum_x, drum_v_x_dot_by_drum_y, drum_v_x_dot_by_post_omega,
        drum_v_x_dot_by_plate_omega, drum_v_x_dot_by_cylinder_v_x, drum_v_x_dot_by_cylinder_v_y,
        drum_v_x_dot_by_cylinder_omega, drum_v_x_dot_by_rod_v_x, drum_v_x_dot_by_rod_v_y,
        drum_v_x_dot_by_rod_omega, drum_v_x_dot_by_bobbin_v_x, drum_v_x_dot_by_bobbin_v_y,
        drum_v_x_dot_by_drum_v_x, drum_v_x_dot_by_drum_v_y, drum_v_y_dot_by_post_phi,
        drum_v_y_dot_by_plate_phi, drum_v_y_dot_by_cylinder_x, drum_v_y_dot_by_cylinder_y,
        drum_v_y_dot_by_cylinder_phi, drum_v_y_dot_by_rod_x, drum_v_y_dot_by_rod_y,
        drum_v_y_dot_by_rod_phi, drum_v_y_dot_by_bobbin_x, drum_v_y_dot_by_bobbin_y,
        drum_v_y_dot_by_drum_x, drum_v_y_dot_by_drum_y, drum_v_y_dot_by_post_omega,
        drum_v_y_dot_by_plate_omega, drum_v_y_dot_by_cylinder_v_x, drum_v_y_dot_by_cylinder_v_y,
        drum_v_y_dot_by_cylinder_omega, drum_v_y_dot_by_rod_v_x, drum_v_y_dot_by_rod_v_y,
        drum_v_y_dot_by_rod_omega, drum_v_y_dot_by_bobbin_v_x, drum_v_y_dot_by_bobbin_v_y,
        drum_v_y_dot_by_drum_v_x, drum_v_y_dot_by_drum_v_y]
}

/// `dy'/dp`, values in the order of its pattern. 2128 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 80] {
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
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t7 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t7)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t8 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t9 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t10 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t11 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t12 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t13 = t8 * R::literal(370.370_370_370_370_3);
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = t9 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t19 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t21 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t22 = slide * R::literal(2_777.777_777_777_778);
    let t23 = sin_cylinder_phi * R::literal(5.0);
    let t24 = cos_cylinder_phi * R::literal(5.0);
    let t25 = R::literal(250.0) * sin_rod_phi;
    let t26 = R::literal(250.0) * cos_rod_phi;
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t27 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t28 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t29 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t30 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = t11 * t1;
    let t32 = R::literal(1.25) + t31;
    let t33 = R::literal(1.0) / t32;
    let t34 = t12 * t1;
    let t35 = t34 * t33;
    let t36 = R::literal(1.25) - t31;
    let t37 = t36 * t33;
    let t38 = t13 * t1;
    let t39 = t38 * t33;
    let t40 = t12 * t0;
    let t41 = R::literal(1.25) + t40;
    let t42 = t35 * t34;
    let t43 = R::literal(1.0) / (t42 - t41);
    let t44 = (t11 * t0).add_product(t37, t34);
    let t45 = t44 * t43;
    let t46 = R::literal(1.25) - t40 + t42;
    let t47 = t46 * t43;
    let t48 = (t13 * t0).sub_product(t39, t34);
    let t49 = t48 * t43;
    let t50 = t14 * t3;
    let t51 = R::literal(1.0) / (-(t32 + R::literal(0.833_333_333_333_333_4) + t50))
        .add_product(t37, t36).sub_product(t45, t44);
    let t52 = t15 * t3;
    let t53 = (t34 + t52).add_product(t35, t36).sub_product(t47, t44);
    let t54 = t53 * t51;
    let t55 = R::literal(0.833_333_333_333_333_4) - t50;
    let t56 = t55 * t51;
    let t57 = t52 * t51;
    let t58 = t16 * t3;
    let t59 = R::literal(0.833_333_333_333_333_4) + t58;
    let t60 = t59 * t51;
    let t61 = t17 * t3;
    let t62 = t61 * t51;
    let t63 = t38.add_product(t39, t36).add_product(t49, t44);
    let t64 = t63 * t51;
    let t65 = t15 * t2;
    let t66 = R::literal(1.0) / (t42 - (t41 + R::literal(0.833_333_333_333_333_4) + t65))
        .sub_product(t47, t46).sub_product(t54, t53);
    let t67 = (t14 * t2).sub_product(t56, t53);
    let t68 = t67 * t66;
    let t69 = (R::literal(0.833_333_333_333_333_4) - t65).sub_product(t57, t53);
    let t70 = t69 * t66;
    let t71 = t16 * t2;
    let t72 = t71.add_product(t60, t53);
    let t73 = t72 * t66;
    let t74 = t17 * t2;
    let t75 = (R::literal(0.833_333_333_333_333_4) + t74).add_product(t62, t53);
    let t76 = t75 * t66;
    let t77 = t48.sub_product(t49, t46).add_product(t64, t53);
    let t78 = t77 * t66;
    let t79 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t50
        + R::literal(3.333_333_333_333_333_5)).add_product(t20, t5).add_product(t56, t55)
        .add_product(t68, t67);
    let t80 = t52.add_product(t21, t5).sub_product(t57, t55).sub_product(t70, t67);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = (-t18).add_product(t22, t5);
    let t85 = t84 * t79;
    let t86 = (t58 - R::literal(0.833_333_333_333_333_4)).sub_product(t60, t55).add_product(t73,
        t67);
    let t87 = t86 * t79;
    let t88 = (-t61).add_product(t62, t55).sub_product(t76, t67);
    let t89 = t88 * t79;
    let t90 = (t64 * t55).sub_product(t78, t67);
    let t91 = t90 * t79;
    let t92 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t65
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t4).add_product(t57, t52)
        .add_product(t70, t69)).add_product(t81, t80);
    let t93 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t83, t80);
    let t94 = t93 * t92;
    let t95 = t19.sub_product(t22, t4).add_product(t85, t80);
    let t96 = t95 * t92;
    let t97 = (-t71.add_product(t60, t52)).add_product(t73, t69).add_product(t87, t80);
    let t98 = t97 * t92;
    let t99 = (t74 - R::literal(0.833_333_333_333_333_4)).add_product(t62, t52).sub_product(t76,
        t69).add_product(t89, t80);
    let t100 = t99 * t92;
    let t101 = (t64 * t52).sub_product(t78, t69).add_product(t91, t80);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t83, t82)
        .sub_product(t94, t93);
    let t104 = t22.add_product(t85, t82).add_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t25 * t103;
    let t107 = t26 * t103;
    let t108 = (t87 * t82).add_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t82).add_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t82).add_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t18 * sin_cylinder_phi).add_product(t19, cos_cylinder_phi)
        .add_product(t22, slide).add_product(t23, sin_cylinder_phi).add_product(t24,
        cos_cylinder_phi)).add_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t23.add_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = t24.add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (t87 * t84).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (t89 * t84).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (t91 * t84).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(5.0).add_product(t25, t6).add_product(t106, t25)
        .add_product(t116, t115);
    let t126 = (t26 * t6).add_product(t107, t25).add_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (t109 * t25).sub_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (t111 * t25).sub_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (t113 * t25).sub_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / (-R::literal(5.0).add_product(t26, R::literal(0.06) * cos_rod_phi)
        .add_product(t107, t26).add_product(t118, t117)).add_product(t127, t126);
    let t135 = (-(t109 * t26)).add_product(t120, t117).add_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (-(t111 * t26)).add_product(t122, t117).add_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (-(t113 * t26)).add_product(t124, t117).add_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t16, t9)
        + inverse_bobbin_mass).add_product(t60, t59).add_product(t73, t72)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t17 * t9).add_product(t62, t59).add_product(t76, t72).add_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).add_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t27 * t141;
    let t145 = (t64 * t59).add_product(t78, t72).add_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).add_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + inverse_bobbin_mass).add_product(t62, t61).add_product(t76, t75)).add_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).add_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t28).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (-(t64 * t61).add_product(t78, t75)).add_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).add_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t29 * bobbin_x_minus_drum_x_over_between;
    let t153 = t30 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (t152 - ((t27 * bobbin_x_minus_drum_x_over_between)
        .add_product(t28, bobbin_y_minus_drum_y_over_between) + t152 + t153).add_product(t144, t27)
        .add_product(t149, t148) + t153);
    let t155 = (t146 * t27).sub_product(t151, t148);
    let t156 = t155 * t154;
    let t157 = R::literal(1.0) / (-(t13 * t8)).add_product(t39, t38).sub_product(t49, t48)
        .sub_product(t64, t63).sub_product(t78, t77).add_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).add_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t158 = R::literal(50.0) * slide_rate;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t159 = p.spring_stiffness * slide_minus_spring_free_length;
    let t160 = (t159 * cos_cylinder_phi).add_product(t158, cos_cylinder_phi);
    let t161 = t159 * sin_cylinder_phi;
    let t162 = t158 * sin_cylinder_phi;
    let t163 = t162 - (R::literal(2.943) - t161);
    let t164 = (t159 * t7).add_product(t158, t7);
    let t165 = t162 + (R::literal(1.962) + t161);
    let t166 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t167 = (p.winding_force * bobbin_x_minus_drum_x / between).sub_product(R::literal(9.81),
        p.bobbin_mass);
    let post_omega_squared = post_omega * post_omega;
    let t168 = R::literal(0.1) * post_omega_squared;
    let t169 = t168 * cos_post_phi;
    let t170 = t168 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t171 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t172 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t173 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t174 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t175 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t176 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t177 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t178 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t179 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t180 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t181 = (bobbin_v_x * (bobbin_v_x_over_between + t175 + t176 - t173 - t174
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t179 + t180
        - t177 - t178 - drum_v_y_over_between).add_product(drum_v_x, t173 + t174
        + drum_v_x_over_between - bobbin_v_x_over_between - t175 - t176).add_product(drum_v_y, t177
        + t178 + drum_v_y_over_between - bobbin_v_y_over_between - t179 - t180);
    let t182 = t35 * t169;
    let t183 = R::literal(9.81) - t170 - t182;
    let t184 = t14 * bobbin_radius_times_winding_force;
    let t185 = (t184 - t169.add_product(t171, cos_plate_phi)).sub_product(t37, t169)
        .sub_product(t45, t183);
    let t186 = t15 * bobbin_radius_times_winding_force;
    let t187 = (R::literal(9.81) - (t170.add_product(t171, sin_plate_phi) + R::literal(9.81))
        - t186 - t182).sub_product(t47, t183).sub_product(t54, t185);
    let t188 = t184.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .sub_product(R::literal(3.333_333_333_333_333_5), t160).add_product(t20, t164)
        .sub_product(t56, t185).sub_product(t68, t187);
    let t189 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t186)
        .add_product(R::literal(3.333_333_333_333_333_5), t163).add_product(t21, t164)
        .add_product(t57, t185).add_product(t70, t187)).add_product(t81, t188);
    let t190 = (R::literal(-2_777.777_777_777_778) * t164).sub_product(t83, t188).sub_product(t94,
        t189);
    let t191 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t160)
        .add_product(t19, t163).sub_product(t22, t164).sub_product(t23, t160).add_product(t24, t165)
        .add_product(t85, t188).sub_product(t96, t189);
    let t192 = t191.add_product(t105, t190);
    let t193 = (t172 * cos_rod_phi).add_product(R::literal(5.0), t160).sub_product(t106, t190)
        .sub_product(t116, t192);
    let t194 = (t172 * sin_rod_phi).add_product(R::literal(5.0), t165).add_product(t107, t190)
        .add_product(t118, t192).add_product(t127, t193);
    let t195 = inverse_bobbin_mass * t166;
    let t196 = ((t10 * plate_omega_squared).sub_product(t16, bobbin_radius_times_winding_force)
        + t195).sub_product(t60, t185).add_product(t73, t187).add_product(t87, t188)
        .sub_product(t98, t189).add_product(t109, t190).sub_product(t120, t192).add_product(t129,
        t193).sub_product(t136, t194);
    let t197 = inverse_bobbin_mass * t167;
    let t198 = (R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        bobbin_radius_times_winding_force) - t197).add_product(t62, t185).sub_product(t76, t187)
        .add_product(t89, t188).sub_product(t100, t189).add_product(t111, t190).sub_product(t122,
        t192).add_product(t131, t193).sub_product(t138, t194).sub_product(t143, t196);
    let t199 = (-t181).add_product(t27, t166).sub_product(t28, t167)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t144, t196).sub_product(t149, t198)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t200 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t39, t169).sub_product(t49, t183).add_product(t64, t185)
        .sub_product(t78, t187).add_product(t91, t188).sub_product(t102, t189).add_product(t113,
        t190).sub_product(t124, t192).add_product(t133, t193).sub_product(t140, t194)
        .sub_product(t146, t196).sub_product(t151, t198).sub_product(t156, t199) * t157;
    let t201 = (t199 * t154).sub_product(t156, t200);
    let t202 = (t198 * t147).sub_product(t149, t201).sub_product(t151, t200);
    let bobbin_v_y_dot = t197.sub_product(inverse_bobbin_mass, t202).sub_product(t28, t201);
    let t203 = t195.add_product(inverse_bobbin_mass, (t196 * t141).sub_product(t143, t202)
        .add_product(t144, t201).sub_product(t146, t200)).add_product(t27, t201);
    let t204 = p.spring_stiffness * cos_cylinder_phi;
    let t205 = p.spring_stiffness * t7;
    let t206 = p.spring_stiffness * sin_cylinder_phi;
    let t207 = t14 * p.winding_force;
    let t208 = t15 * p.winding_force;
    let t209 = t208.add_product(t54, t207);
    let t210 = t207.sub_product(t56, t207).add_product(t68, t209);
    let t211 = (-t208.add_product(t57, t207)).add_product(t70, t209).add_product(t81, t210);
    let t212 = (t83 * t210).add_product(t94, t211);
    let t213 = (t85 * t210).sub_product(t96, t211).sub_product(t105, t212);
    let t214 = (t106 * t212).sub_product(t116, t213);
    let t215 = (-(t107 * t212)).add_product(t118, t213).add_product(t127, t214);
    let t216 = (-(t16 * p.winding_force).add_product(t60, t207).add_product(t73, t209))
        .add_product(t87, t210).sub_product(t98, t211).sub_product(t109, t212).sub_product(t120,
        t213).add_product(t129, t214).sub_product(t136, t215);
    let t217 = (t17 * p.winding_force).add_product(t62, t207).add_product(t76, t209)
        .add_product(t89, t210).sub_product(t100, t211).sub_product(t111, t212).sub_product(t122,
        t213).add_product(t131, t214).sub_product(t138, t215).sub_product(t143, t216);
    let t218 = (t144 * t216).sub_product(t149, t217);
    let t219 = (t64 * t207).add_product(t78, t209).add_product(t91, t210).sub_product(t102, t211)
        .sub_product(t113, t212).sub_product(t124, t213).add_product(t133, t214).sub_product(t140,
        t215).sub_product(t146, t216).sub_product(t151, t217).sub_product(t156, t218) * t157;
    let t220 = (t218 * t154).sub_product(t156, t219);
    let t221 = (t217 * t147).sub_product(t149, t220).sub_product(t151, t219);
    let t222 = (t216 * t141).sub_product(t143, t221).add_product(t144, t220).sub_product(t146,
        t219);
    let t223 = (t215 * t134).sub_product(t136, t222).sub_product(t138, t221).sub_product(t140,
        t219);
    let t224 = (-(t214 * t125)).add_product(t127, t223).add_product(t129, t222).add_product(t131,
        t221).add_product(t133, t219);
    let t225 = (t213 * t114).sub_product(t116, t224).add_product(t118, t223).sub_product(t120, t222)
        .sub_product(t122, t221).sub_product(t124, t219);
    let t226 = (-(t212 * t103)).add_product(t105, t225).sub_product(t106, t224).add_product(t107,
        t223).add_product(t109, t222).add_product(t111, t221).add_product(t113, t219);
    let t227 = (t211 * t92).sub_product(t94, t226).sub_product(t96, t225).sub_product(t98, t222)
        .sub_product(t100, t221).sub_product(t102, t219);
    let t228 = (-(t210 * t79)).add_product(t81, t227).sub_product(t83, t226).add_product(t85, t225)
        .add_product(t87, t222).add_product(t89, t221).add_product(t91, t219);
    let t229 = (-(t209 * t66).add_product(t68, t228).add_product(t70, t227)).add_product(t73, t222)
        .sub_product(t76, t221).sub_product(t78, t219);
    let t230 = (t207 * t51).sub_product(t54, t229).sub_product(t56, t228).sub_product(t57, t227)
        .sub_product(t60, t222).add_product(t62, t221).add_product(t64, t219);
    let t231 = (t47 * t229).add_product(t45, t230).add_product(t49, t219);
    let t232 = (t37 * t230).sub_product(t35, t231).add_product(t35, t229).sub_product(t39, t219);
    let drum_v_y_dot_by_bobbin_radius = (t30 * t220)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t220);
    let drum_v_x_dot_by_bobbin_radius = (t29 * t220)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t220);
    let bobbin_v_y_dot_by_bobbin_radius = -(t28 * t220).add_product(inverse_bobbin_mass, t221);
    let bobbin_v_x_dot_by_bobbin_radius = -(t27 * t220).add_product(inverse_bobbin_mass, t222);
    let rod_omega_dot_by_bobbin_radius = (t25 * t224)
        .sub_product(R::literal(4_166.666_666_666_667), t226).sub_product(t26, t223);
    let rod_v_y_dot_by_bobbin_radius = (R::literal(-5.0) * t223).sub_product(t24, t225);
    let rod_v_x_dot_by_bobbin_radius = (R::literal(-5.0) * t224).add_product(t23, t225);
    let cylinder_omega_dot_by_bobbin_radius = (t21 * t227).sub_product(t20, t228)
        .sub_product(R::literal(-2_777.777_777_777_778), t226).add_product(t22, t225);
    let cylinder_v_y_dot_by_bobbin_radius = (t19 * t225)
        .sub_product(R::literal(3.333_333_333_333_333_5), t227);
    let cylinder_v_x_dot_by_bobbin_radius = (-(t18 * t225))
        .add_product(R::literal(-3.333_333_333_333_333_5), t228);
    let plate_omega_dot_by_bobbin_radius = (-(p.winding_force * R::literal(400.0)).add_product(t14,
        t230)).add_product(t15, t229).sub_product(t14, t228).add_product(t15, t227)
        .add_product(t16, t222).sub_product(t17, t221);
    let plate_v_y_dot_by_bobbin_radius = (R::literal(0.833_333_333_333_333_4) * t227)
        .add_product(R::literal(-0.833_333_333_333_333_4), t229)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t221);
    let plate_v_x_dot_by_bobbin_radius = (R::literal(0.833_333_333_333_333_4) * t228)
        .add_product(R::literal(-0.833_333_333_333_333_4), t230)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t222);
    let post_omega_dot_by_bobbin_radius = (-(t12 * t231).add_product(t11, t232).add_product(t11,
        t230)).add_product(t12, t229).sub_product(t13, t219);
    let post_v_y_dot_by_bobbin_radius = (R::literal(1.25) * t229).add_product(R::literal(1.25),
        t231);
    let post_v_x_dot_by_bobbin_radius = (R::literal(1.25) * t230).add_product(R::literal(-1.25),
        t232);
    let t233 = t14 * p.bobbin_radius;
    let t234 = t15 * p.bobbin_radius;
    let t235 = t234.add_product(t54, t233);
    let t236 = t233.sub_product(t56, t233).add_product(t68, t235);
    let t237 = (-t234.add_product(t57, t233)).add_product(t70, t235).add_product(t81, t236);
    let t238 = (t83 * t236).add_product(t94, t237);
    let t239 = (t85 * t236).sub_product(t96, t237).sub_product(t105, t238);
    let t240 = (t106 * t238).sub_product(t116, t239);
    let t241 = (-(t107 * t238)).add_product(t118, t239).add_product(t127, t240);
    let t242 = t28.sub_product(t16, p.bobbin_radius).sub_product(t60, t233).sub_product(t73, t235)
        .add_product(t87, t236).sub_product(t98, t237).sub_product(t109, t238).sub_product(t120,
        t239).add_product(t129, t240).sub_product(t136, t241);
    let t243 = (-t27).add_product(t17, p.bobbin_radius).add_product(t62, t233).add_product(t76,
        t235).add_product(t89, t236).sub_product(t100, t237).sub_product(t111, t238)
        .sub_product(t122, t239).add_product(t131, t240).sub_product(t138, t241).sub_product(t143,
        t242);
    let t244 = (t27 * bobbin_y_minus_drum_y_over_between).sub_product(t28,
        bobbin_x_minus_drum_x_over_between).add_product(t144, t242).sub_product(t149, t243);
    let t245 = (t64 * t233).add_product(t78, t235).add_product(t91, t236).sub_product(t102, t237)
        .sub_product(t113, t238).sub_product(t124, t239).add_product(t133, t240).sub_product(t140,
        t241).sub_product(t146, t242).sub_product(t151, t243).sub_product(t156, t244) * t157;
    let t246 = (t244 * t154).sub_product(t156, t245);
    let t247 = (t243 * t147).sub_product(t149, t246).sub_product(t151, t245);
    let t248 = (t242 * t141).sub_product(t143, t247).add_product(t144, t246).sub_product(t146,
        t245);
    let t249 = (t241 * t134).sub_product(t136, t248).sub_product(t138, t247).sub_product(t140,
        t245);
    let t250 = (-(t240 * t125)).add_product(t127, t249).add_product(t129, t248).add_product(t131,
        t247).add_product(t133, t245);
    let t251 = (t239 * t114).sub_product(t116, t250).add_product(t118, t249).sub_product(t120, t248)
        .sub_product(t122, t247).sub_product(t124, t245);
    let t252 = (-(t238 * t103)).add_product(t105, t251).sub_product(t106, t250).add_product(t107,
        t249).add_product(t109, t248).add_product(t111, t247).add_product(t113, t245);
    let t253 = (t237 * t92).sub_product(t94, t252).sub_product(t96, t251).sub_product(t98, t248)
        .sub_product(t100, t247).sub_product(t102, t245);
    let t254 = (-(t236 * t79)).add_product(t81, t253).sub_product(t83, t252).add_product(t85, t251)
        .add_product(t87, t248).add_product(t89, t247).add_product(t91, t245);
    let t255 = (-(t235 * t66).add_product(t68, t254).add_product(t70, t253)).add_product(t73, t248)
        .sub_product(t76, t247).sub_product(t78, t245);
    let t256 = (t233 * t51).sub_product(t54, t255).sub_product(t56, t254).sub_product(t57, t253)
        .sub_product(t60, t248).add_product(t62, t247).add_product(t64, t245);
    let t257 = (t47 * t255).add_product(t45, t256).add_product(t49, t245);
    let t258 = (t37 * t256).sub_product(t35, t257).add_product(t35, t255).sub_product(t39, t245);
    let drum_v_y_dot_by_winding_force = (t30 * t246)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t246);
    let drum_v_x_dot_by_winding_force = (t29 * t246)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t246);
    let bobbin_v_y_dot_by_winding_force = t27.sub_product(inverse_bobbin_mass, t247)
        .sub_product(t28, t246);
    let bobbin_v_x_dot_by_winding_force = -t28.add_product(inverse_bobbin_mass, t248)
        .add_product(t27, t246);
    let rod_omega_dot_by_winding_force = (t25 * t250)
        .sub_product(R::literal(4_166.666_666_666_667), t252).sub_product(t26, t249);
    let rod_v_y_dot_by_winding_force = (R::literal(-5.0) * t249).sub_product(t24, t251);
    let rod_v_x_dot_by_winding_force = (R::literal(-5.0) * t250).add_product(t23, t251);
    let cylinder_omega_dot_by_winding_force = (t21 * t253).sub_product(t20, t254)
        .sub_product(R::literal(-2_777.777_777_777_778), t252).add_product(t22, t251);
    let cylinder_v_y_dot_by_winding_force = (t19 * t251)
        .sub_product(R::literal(3.333_333_333_333_333_5), t253);
    let cylinder_v_x_dot_by_winding_force = (-(t18 * t251))
        .add_product(R::literal(-3.333_333_333_333_333_5), t254);
    let plate_omega_dot_by_winding_force = (-(p.bobbin_radius * R::literal(400.0)).add_product(t14,
        t256)).add_product(t15, t255).sub_product(t14, t254).add_product(t15, t253)
        .add_product(t16, t248).sub_product(t17, t247);
    let plate_v_y_dot_by_winding_force = (R::literal(0.833_333_333_333_333_4) * t253)
        .add_product(R::literal(-0.833_333_333_333_333_4), t255)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t247);
    let plate_v_x_dot_by_winding_force = (R::literal(0.833_333_333_333_333_4) * t254)
        .add_product(R::literal(-0.833_333_333_333_333_4), t256)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t248);
    let post_omega_dot_by_winding_force = (-(t12 * t257).add_product(t11, t258).add_product(t11,
        t256)).add_product(t12, t255).sub_product(t13, t245);
    let post_v_y_dot_by_winding_force = (R::literal(1.25) * t255).add_product(R::literal(1.25),
        t257);
    let post_v_x_dot_by_winding_force = (R::literal(1.25) * t256).add_product(R::literal(-1.25),
        t258);
    let t259 = R::literal(9.81) + bobbin_v_y_dot;
    let t260 = inverse_bobbin_mass * t203;
    let t261 = inverse_bobbin_mass * t259;
    let t262 = t261.add_product(t143, t260);
    let t263 = (t28 * t259).sub_product(t27, t203).sub_product(t144, t260).sub_product(t149, t262);
    let t264 = (t146 * t260).sub_product(t151, t262).sub_product(t156, t263) * t157;
    let t265 = (t263 * t154).sub_product(t156, t264);
    let t266 = (t262 * t147).sub_product(t149, t265).sub_product(t151, t264);
    let t267 = (-(t260 * t141).add_product(t143, t266)).add_product(t144, t265).sub_product(t146,
        t264);
    let t268 = (t138 * t266).add_product(t136, t267).add_product(t140, t264);
    let t269 = (t129 * t267).sub_product(t127, t268).add_product(t131, t266).add_product(t133,
        t264);
    let t270 = (t118 * t268).add_product(t116, t269).add_product(t120, t267).add_product(t122, t266)
        .add_product(t124, t264);
    let t271 = (-(t106 * t269).add_product(t105, t270).add_product(t107, t268)).add_product(t109,
        t267).add_product(t111, t266).add_product(t113, t264);
    let t272 = (t96 * t270).sub_product(t94, t271).sub_product(t98, t267).sub_product(t100, t266)
        .sub_product(t102, t264);
    let t273 = (-(t83 * t271)).add_product(t81, t272).sub_product(t85, t270).add_product(t87, t267)
        .add_product(t89, t266).add_product(t91, t264);
    let t274 = (-(t70 * t272).add_product(t68, t273)).add_product(t73, t267).sub_product(t76, t266)
        .sub_product(t78, t264);
    let t275 = (-(t56 * t273).add_product(t54, t274).add_product(t57, t272).add_product(t60, t267))
        .add_product(t62, t266).add_product(t64, t264);
    let t276 = (t47 * t274).add_product(t45, t275).add_product(t49, t264);
    let t277 = (t37 * t275).sub_product(t35, t276).add_product(t35, t274).sub_product(t39, t264);
    let drum_v_y_dot_by_bobbin_mass = (t30 * t265).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t265);
    let drum_v_x_dot_by_bobbin_mass = (t29 * t265).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t265);
    let bobbin_v_y_dot_by_bobbin_mass = -t261.add_product(inverse_bobbin_mass, t266)
        .add_product(t28, t265);
    let bobbin_v_x_dot_by_bobbin_mass = t260.sub_product(inverse_bobbin_mass, t267)
        .sub_product(t27, t265);
    let rod_omega_dot_by_bobbin_mass = (t25 * t269).sub_product(R::literal(4_166.666_666_666_667),
        t271).add_product(t26, t268);
    let rod_v_y_dot_by_bobbin_mass = (R::literal(5.0) * t268).add_product(t24, t270);
    let rod_v_x_dot_by_bobbin_mass = (R::literal(-5.0) * t269).sub_product(t23, t270);
    let cylinder_omega_dot_by_bobbin_mass = (t21 * t272).sub_product(t20, t273)
        .sub_product(R::literal(-2_777.777_777_777_778), t271).sub_product(t22, t270);
    let cylinder_v_y_dot_by_bobbin_mass = (-(t19 * t270))
        .add_product(R::literal(-3.333_333_333_333_333_5), t272);
    let cylinder_v_x_dot_by_bobbin_mass = (t18 * t270)
        .sub_product(R::literal(3.333_333_333_333_333_5), t273);
    let plate_omega_dot_by_bobbin_mass = (t15 * t274).sub_product(t14, t275).sub_product(t14, t273)
        .add_product(t15, t272).add_product(t16, t267).sub_product(t17, t266);
    let plate_v_y_dot_by_bobbin_mass = (R::literal(0.833_333_333_333_333_4) * t272)
        .add_product(R::literal(-0.833_333_333_333_333_4), t274)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t266);
    let plate_v_x_dot_by_bobbin_mass = (R::literal(0.833_333_333_333_333_4) * t273)
        .add_product(R::literal(-0.833_333_333_333_333_4), t275)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t267);
    let post_omega_dot_by_bobbin_mass = (-(t12 * t276).add_product(t11, t277).add_product(t11,
        t275)).add_product(t12, t274).sub_product(t13, t264);
    let post_v_y_dot_by_bobbin_mass = (R::literal(1.25) * t274).add_product(R::literal(1.25), t276);
    let post_v_x_dot_by_bobbin_mass = (R::literal(1.25) * t275).add_product(R::literal(-1.25),
        t277);
    let t278 = slide_minus_spring_free_length * cos_cylinder_phi;
    let t279 = slide_minus_spring_free_length * sin_cylinder_phi;
    let t280 = slide_minus_spring_free_length * t7;
    let t281 = R::literal(3.333_333_333_333_333_5) * t278;
    let t282 = (-t281).add_product(t20, t280);
    let t283 = R::literal(3.333_333_333_333_333_5) * t279;
    let t284 = (-t283.add_product(t21, t280)).add_product(t81, t282);
    let t285 = (R::literal(-2_777.777_777_777_778) * t280).sub_product(t83, t282).sub_product(t94,
        t284);
    let t286 = (t19 * t279).sub_product(t18, t278).sub_product(t22, t280).sub_product(t23, t278)
        .add_product(t24, t279).add_product(t85, t282).sub_product(t96, t284).add_product(t105,
        t285);
    let t287 = R::literal(5.0) * t278;
    let t288 = t287.sub_product(t106, t285).sub_product(t116, t286);
    let t289 = R::literal(5.0) * t279;
    let t290 = t289.add_product(t107, t285).add_product(t118, t286).add_product(t127, t288);
    let t291 = (t87 * t282).sub_product(t98, t284).add_product(t109, t285).sub_product(t120, t286)
        .add_product(t129, t288).sub_product(t136, t290);
    let t292 = (t89 * t282).sub_product(t100, t284).add_product(t111, t285).sub_product(t122, t286)
        .add_product(t131, t288).sub_product(t138, t290).sub_product(t143, t291);
    let t293 = (t144 * t291).sub_product(t149, t292);
    let t294 = (t91 * t282).sub_product(t102, t284).add_product(t113, t285).sub_product(t124, t286)
        .add_product(t133, t288).sub_product(t140, t290).sub_product(t146, t291).sub_product(t151,
        t292).sub_product(t156, t293) * t157;
    let t295 = (t293 * t154).sub_product(t156, t294);
    let t296 = (t292 * t147).sub_product(t149, t295).sub_product(t151, t294);
    let t297 = (t291 * t141).sub_product(t143, t296).add_product(t144, t295).sub_product(t146,
        t294);
    let t298 = (t290 * t134).sub_product(t136, t297).sub_product(t138, t296).sub_product(t140,
        t294);
    let t299 = (-(t288 * t125)).add_product(t127, t298).add_product(t129, t297).add_product(t131,
        t296).add_product(t133, t294);
    let t300 = (t286 * t114).sub_product(t116, t299).add_product(t118, t298).sub_product(t120, t297)
        .sub_product(t122, t296).sub_product(t124, t294);
    let t301 = (t285 * t103).add_product(t105, t300).sub_product(t106, t299).add_product(t107, t298)
        .add_product(t109, t297).add_product(t111, t296).add_product(t113, t294);
    let t302 = (t284 * t92).sub_product(t94, t301).sub_product(t96, t300).sub_product(t98, t297)
        .sub_product(t100, t296).sub_product(t102, t294);
    let t303 = (-(t282 * t79)).add_product(t81, t302).sub_product(t83, t301).add_product(t85, t300)
        .add_product(t87, t297).add_product(t89, t296).add_product(t91, t294);
    let t304 = (-(t70 * t302).add_product(t68, t303)).add_product(t73, t297).sub_product(t76, t296)
        .sub_product(t78, t294);
    let t305 = (-(t56 * t303).add_product(t54, t304).add_product(t57, t302).add_product(t60, t297))
        .add_product(t62, t296).add_product(t64, t294);
    let t306 = (t47 * t304).add_product(t45, t305).add_product(t49, t294);
    let t307 = (t37 * t305).sub_product(t35, t306).add_product(t35, t304).sub_product(t39, t294);
    let drum_v_y_dot_by_spring_stiffness = (t30 * t295)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t295);
    let drum_v_x_dot_by_spring_stiffness = (t29 * t295)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t295);
    let bobbin_v_y_dot_by_spring_stiffness = -(t28 * t295).add_product(inverse_bobbin_mass, t296);
    let bobbin_v_x_dot_by_spring_stiffness = -(t27 * t295).add_product(inverse_bobbin_mass, t297);
    let rod_omega_dot_by_spring_stiffness = (t25 * t299)
        .sub_product(R::literal(4_166.666_666_666_667), t301).sub_product(t26, t298);
    let rod_v_y_dot_by_spring_stiffness = (-t289.add_product(t24, t300))
        .add_product(R::literal(-5.0), t298);
    let rod_v_x_dot_by_spring_stiffness = (-t287).add_product(t23, t300)
        .sub_product(R::literal(5.0), t299);
    let cylinder_omega_dot_by_spring_stiffness = (-(t280 * R::literal(2_777.777_777_777_778))
        .add_product(t20, t303)).add_product(t21, t302)
        .sub_product(R::literal(-2_777.777_777_777_778), t301).add_product(t22, t300);
    let cylinder_v_y_dot_by_spring_stiffness = t283
        .sub_product(R::literal(3.333_333_333_333_333_5), t302).add_product(t19, t300);
    let cylinder_v_x_dot_by_spring_stiffness = t281
        .sub_product(R::literal(3.333_333_333_333_333_5), t303).sub_product(t18, t300);
    let plate_omega_dot_by_spring_stiffness = (t15 * t304).sub_product(t14, t305).sub_product(t14,
        t303).add_product(t15, t302).add_product(t16, t297).sub_product(t17, t296);
    let plate_v_y_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t302)
        .add_product(R::literal(-0.833_333_333_333_333_4), t304)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t296);
    let plate_v_x_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t303)
        .add_product(R::literal(-0.833_333_333_333_333_4), t305)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t297);
    let post_omega_dot_by_spring_stiffness = (-(t12 * t306).add_product(t11, t307).add_product(t11,
        t305)).add_product(t12, t304).sub_product(t13, t294);
    let post_v_y_dot_by_spring_stiffness = (R::literal(1.25) * t304).add_product(R::literal(1.25),
        t306);
    let post_v_x_dot_by_spring_stiffness = (R::literal(1.25) * t305).add_product(R::literal(-1.25),
        t307);
    let t308 = R::literal(3.333_333_333_333_333_5) * t204;
    let t309 = t308.sub_product(t20, t205);
    let t310 = R::literal(3.333_333_333_333_333_5) * t206;
    let t311 = t310.add_product(t21, t205).add_product(t81, t309);
    let t312 = (R::literal(-2_777.777_777_777_778) * t205).add_product(t83, t309).add_product(t94,
        t311);
    let t313 = (t18 * t204).sub_product(t19, t206).add_product(t22, t205).add_product(t23, t204)
        .sub_product(t24, t206).add_product(t85, t309).sub_product(t96, t311).sub_product(t105,
        t312);
    let t314 = R::literal(5.0) * t204;
    let t315 = (-t314).add_product(t106, t312).sub_product(t116, t313);
    let t316 = R::literal(5.0) * t206;
    let t317 = (-t316.add_product(t107, t312)).add_product(t118, t313).add_product(t127, t315);
    let t318 = (t87 * t309).sub_product(t98, t311).sub_product(t109, t312).sub_product(t120, t313)
        .add_product(t129, t315).sub_product(t136, t317);
    let t319 = (t89 * t309).sub_product(t100, t311).sub_product(t111, t312).sub_product(t122, t313)
        .add_product(t131, t315).sub_product(t138, t317).sub_product(t143, t318);
    let t320 = (t144 * t318).sub_product(t149, t319);
    let t321 = (t91 * t309).sub_product(t102, t311).sub_product(t113, t312).sub_product(t124, t313)
        .add_product(t133, t315).sub_product(t140, t317).sub_product(t146, t318).sub_product(t151,
        t319).sub_product(t156, t320) * t157;
    let t322 = (t320 * t154).sub_product(t156, t321);
    let t323 = (t319 * t147).sub_product(t149, t322).sub_product(t151, t321);
    let t324 = (t318 * t141).sub_product(t143, t323).add_product(t144, t322).sub_product(t146,
        t321);
    let t325 = (t317 * t134).sub_product(t136, t324).sub_product(t138, t323).sub_product(t140,
        t321);
    let t326 = (-(t315 * t125)).add_product(t127, t325).add_product(t129, t324).add_product(t131,
        t323).add_product(t133, t321);
    let t327 = (t313 * t114).sub_product(t116, t326).add_product(t118, t325).sub_product(t120, t324)
        .sub_product(t122, t323).sub_product(t124, t321);
    let t328 = (-(t312 * t103)).add_product(t105, t327).sub_product(t106, t326).add_product(t107,
        t325).add_product(t109, t324).add_product(t111, t323).add_product(t113, t321);
    let t329 = (t311 * t92).sub_product(t94, t328).sub_product(t96, t327).sub_product(t98, t324)
        .sub_product(t100, t323).sub_product(t102, t321);
    let t330 = (-(t309 * t79)).add_product(t81, t329).sub_product(t83, t328).add_product(t85, t327)
        .add_product(t87, t324).add_product(t89, t323).add_product(t91, t321);
    let t331 = (-(t70 * t329).add_product(t68, t330)).add_product(t73, t324).sub_product(t76, t323)
        .sub_product(t78, t321);
    let t332 = (-(t56 * t330).add_product(t54, t331).add_product(t57, t329).add_product(t60, t324))
        .add_product(t62, t323).add_product(t64, t321);
    let t333 = (t47 * t331).add_product(t45, t332).add_product(t49, t321);
    let t334 = (t37 * t332).sub_product(t35, t333).add_product(t35, t331).sub_product(t39, t321);
    let drum_v_y_dot_by_spring_free_length = (t30 * t322)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t322);
    let drum_v_x_dot_by_spring_free_length = (t29 * t322)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t322);
    let bobbin_v_y_dot_by_spring_free_length = -(t28 * t322).add_product(inverse_bobbin_mass, t323);
    let bobbin_v_x_dot_by_spring_free_length = -(t27 * t322).add_product(inverse_bobbin_mass, t324);
    let rod_omega_dot_by_spring_free_length = (t25 * t326)
        .sub_product(R::literal(4_166.666_666_666_667), t328).sub_product(t26, t325);
    let rod_v_y_dot_by_spring_free_length = t316.sub_product(t24, t327)
        .sub_product(R::literal(5.0), t325);
    let rod_v_x_dot_by_spring_free_length = t314.add_product(t23, t327)
        .sub_product(R::literal(5.0), t326);
    let cylinder_omega_dot_by_spring_free_length = (t205 * R::literal(2_777.777_777_777_778))
        .sub_product(t20, t330).add_product(t21, t329)
        .sub_product(R::literal(-2_777.777_777_777_778), t328).add_product(t22, t327);
    let cylinder_v_y_dot_by_spring_free_length = (-t310
        .add_product(R::literal(3.333_333_333_333_333_5), t329)).add_product(t19, t327);
    let cylinder_v_x_dot_by_spring_free_length = (-t308)
        .add_product(R::literal(-3.333_333_333_333_333_5), t330).sub_product(t18, t327);
    let plate_omega_dot_by_spring_free_length = (t15 * t331).sub_product(t14, t332)
        .sub_product(t14, t330).add_product(t15, t329).add_product(t16, t324).sub_product(t17,
        t323);
    let plate_v_y_dot_by_spring_free_length = (R::literal(0.833_333_333_333_333_4) * t329)
        .add_product(R::literal(-0.833_333_333_333_333_4), t331)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t323);
    let plate_v_x_dot_by_spring_free_length = (R::literal(0.833_333_333_333_333_4) * t330)
        .add_product(R::literal(-0.833_333_333_333_333_4), t332)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t324);
    let post_omega_dot_by_spring_free_length = (-(t12 * t333).add_product(t11, t334)
        .add_product(t11, t332)).add_product(t12, t331).sub_product(t13, t321);
    let post_v_y_dot_by_spring_free_length = (R::literal(1.25) * t331)
        .add_product(R::literal(1.25), t333);
    let post_v_x_dot_by_spring_free_length = (R::literal(1.25) * t332)
        .add_product(R::literal(-1.25), t334);
    [post_v_x_dot_by_bobbin_radius, post_v_x_dot_by_winding_force, post_v_x_dot_by_bobbin_mass,
        post_v_x_dot_by_spring_stiffness, post_v_x_dot_by_spring_free_length,
        post_v_y_dot_by_bobbin_radius, post_v_y_dot_by_winding_force, post_v_y_dot_by_bobbin_mass,
        post_v_y_dot_by_spring_stiffness, post_v_y_dot_by_spring_free_length,
        post_omega_dot_by_bobbin_radius, post_omega_dot_by_winding_force,
        post_omega_dot_by_bobbin_mass, post_omega_dot_by_spring_stiffness,
        post_omega_dot_by_spring_free_length, plate_v_x_dot_by_bobbin_radius,
        plate_v_x_dot_by_winding_force, plate_v_x_dot_by_bobbin_mass,
        plate_v_x_dot_by_spring_stiffness, plate_v_x_dot_by_spring_free_length,
        plate_v_y_dot_by_bobbin_radius, plate_v_y_dot_by_winding_force,
        plate_v_y_dot_by_bobbin_mass, plate_v_y_dot_by_spring_stiffness,
        plate_v_y_dot_by_spring_free_length, plate_omega_dot_by_bobbin_radius,
        plate_omega_dot_by_winding_force, plate_omega_dot_by_bobbin_mass,
        plate_omega_dot_by_spring_stiffness, plate_omega_dot_by_spring_free_length,
        cylinder_v_x_dot_by_bobbin_radius, cylinder_v_x_dot_by_winding_force,
        cylinder_v_x_dot_by_bobbin_mass, cylinder_v_x_dot_by_spring_stiffness,
        cylinder_v_x_dot_by_spring_free_length, cylinder_v_y_dot_by_bobbin_radius,
        cylinder_v_y_dot_by_winding_force, cylinder_v_y_dot_by_bobbin_mass,
        cylinder_v_y_dot_by_spring_stiffness, cylinder_v_y_dot_by_spring_free_length,
        cylinder_omega_dot_by_bobbin_radius, cylinder_omega_dot_by_winding_force,
        cylinder_omega_dot_by_bobbin_mass, cylinder_omega_dot_by_spring_stiffness,
        cylinder_omega_dot_by_spring_free_length, rod_v_x_dot_by_bobbin_radius,
        rod_v_x_dot_by_winding_force, rod_v_x_dot_by_bobbin_mass, rod_v_x_dot_by_spring_stiffness,
        rod_v_x_dot_by_spring_free_length, rod_v_y_dot_by_bobbin_radius,
        rod_v_y_dot_by_winding_force, rod_v_y_dot_by_bobbin_mass, rod_v_y_dot_by_spring_stiffness,
        rod_v_y_dot_by_spring_free_length, rod_omega_dot_by_bobbin_radius,
        rod_omega_dot_by_winding_force, rod_omega_dot_by_bobbin_mass,
        rod_omega_dot_by_spring_stiffness, rod_omega_dot_by_spring_free_length,
        bobbin_v_x_dot_by_bobbin_radius, bobbin_v_x_dot_by_winding_force,
        bobbin_v_x_dot_by_bobbin_mass, bobbin_v_x_dot_by_spring_stiffness,
        bobbin_v_x_dot_by_spring_free_length, bobbin_v_y_dot_by_bobbin_radius,
        bobbin_v_y_dot_by_winding_force, bobbin_v_y_dot_by_bobbin_mass,
        bobbin_v_y_dot_by_spring_stiffness, bobbin_v_y_dot_by_spring_free_length,
        drum_v_x_dot_by_bobbin_radius, drum_v_x_dot_by_winding_force, drum_v_x_dot_by_bobbin_mass,
        drum_v_x_dot_by_spring_stiffness, drum_v_x_dot_by_spring_free_length,
        drum_v_y_dot_by_bobbin_radius, drum_v_y_dot_by_winding_force, drum_v_y_dot_by_bobbin_mass,
        drum_v_y_dot_by_spring_stiffness, drum_v_y_dot_by_spring_free_length]
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

/// Wanted outputs. 780 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, bobbin_phi, drum_x, drum_y, drum_phi, _, _, post_omega, _, _,
        plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
        bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
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
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t7 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t7)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t8 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t9 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t10 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t11 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t12 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t13 = t8 * R::literal(370.370_370_370_370_3);
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = t9 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t19 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t21 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t22 = slide * R::literal(2_777.777_777_777_778);
    let t23 = sin_cylinder_phi * R::literal(5.0);
    let t24 = cos_cylinder_phi * R::literal(5.0);
    let t25 = R::literal(250.0) * sin_rod_phi;
    let t26 = R::literal(250.0) * cos_rod_phi;
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t27 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t28 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t29 = t11 * t1;
    let t30 = R::literal(1.25) + t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t12 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t13 * t1;
    let t37 = t36 * t31;
    let t38 = t12 * t0;
    let t39 = R::literal(1.25) + t38;
    let t40 = t33 * t32;
    let t41 = R::literal(1.0) / (t40 - t39);
    let t42 = (t11 * t0).add_product(t35, t32);
    let t43 = t42 * t41;
    let t44 = R::literal(1.25) - t38 + t40;
    let t45 = t44 * t41;
    let t46 = (t13 * t0).sub_product(t37, t32);
    let t47 = t46 * t41;
    let t48 = t14 * t3;
    let t49 = R::literal(1.0) / (-(t30 + R::literal(0.833_333_333_333_333_4) + t48))
        .add_product(t35, t34).sub_product(t43, t42);
    let t50 = t15 * t3;
    let t51 = (t32 + t50).add_product(t33, t34).sub_product(t45, t42);
    let t52 = t51 * t49;
    let t53 = R::literal(0.833_333_333_333_333_4) - t48;
    let t54 = t53 * t49;
    let t55 = t50 * t49;
    let t56 = t16 * t3;
    let t57 = R::literal(0.833_333_333_333_333_4) + t56;
    let t58 = t57 * t49;
    let t59 = t17 * t3;
    let t60 = t59 * t49;
    let t61 = t36.add_product(t37, t34).add_product(t47, t42);
    let t62 = t61 * t49;
    let t63 = t15 * t2;
    let t64 = R::literal(1.0) / (t40 - (t39 + R::literal(0.833_333_333_333_333_4) + t63))
        .sub_product(t45, t44).sub_product(t52, t51);
    let t65 = (t14 * t2).sub_product(t54, t51);
    let t66 = t65 * t64;
    let t67 = (R::literal(0.833_333_333_333_333_4) - t63).sub_product(t55, t51);
    let t68 = t67 * t64;
    let t69 = t16 * t2;
    let t70 = t69.add_product(t58, t51);
    let t71 = t70 * t64;
    let t72 = t17 * t2;
    let t73 = (R::literal(0.833_333_333_333_333_4) + t72).add_product(t60, t51);
    let t74 = t73 * t64;
    let t75 = t46.sub_product(t47, t44).add_product(t62, t51);
    let t76 = t75 * t64;
    let t77 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t48
        + R::literal(3.333_333_333_333_333_5)).add_product(t20, t5).add_product(t54, t53)
        .add_product(t66, t65);
    let t78 = t50.add_product(t21, t5).sub_product(t55, t53).sub_product(t68, t65);
    let t79 = t78 * t77;
    let t80 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t81 = t80 * t77;
    let t82 = (-t18).add_product(t22, t5);
    let t83 = t82 * t77;
    let t84 = (t56 - R::literal(0.833_333_333_333_333_4)).sub_product(t58, t53).add_product(t71,
        t65);
    let t85 = t84 * t77;
    let t86 = (-t59).add_product(t60, t53).sub_product(t74, t65);
    let t87 = t86 * t77;
    let t88 = (t62 * t53).sub_product(t76, t65);
    let t89 = t88 * t77;
    let t90 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t63
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t4).add_product(t55, t50)
        .add_product(t68, t67)).add_product(t79, t78);
    let t91 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t81, t78);
    let t92 = t91 * t90;
    let t93 = t19.sub_product(t22, t4).add_product(t83, t78);
    let t94 = t93 * t90;
    let t95 = (-t69.add_product(t58, t50)).add_product(t71, t67).add_product(t85, t78);
    let t96 = t95 * t90;
    let t97 = (t72 - R::literal(0.833_333_333_333_333_4)).add_product(t60, t50).sub_product(t74,
        t67).add_product(t87, t78);
    let t98 = t97 * t90;
    let t99 = (t62 * t50).sub_product(t76, t67).add_product(t89, t78);
    let t100 = t99 * t90;
    let t101 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t81, t80)
        .sub_product(t92, t91);
    let t102 = t22.add_product(t83, t80).add_product(t94, t91);
    let t103 = t102 * t101;
    let t104 = t25 * t101;
    let t105 = t26 * t101;
    let t106 = (t85 * t80).add_product(t96, t91);
    let t107 = t106 * t101;
    let t108 = (t87 * t80).add_product(t98, t91);
    let t109 = t108 * t101;
    let t110 = (t89 * t80).add_product(t100, t91);
    let t111 = t110 * t101;
    let t112 = R::literal(1.0) / (-(t18 * sin_cylinder_phi).add_product(t19, cos_cylinder_phi)
        .add_product(t22, slide).add_product(t23, sin_cylinder_phi).add_product(t24,
        cos_cylinder_phi)).add_product(t83, t82).sub_product(t94, t93).sub_product(t103, t102);
    let t113 = t23.add_product(t104, t102);
    let t114 = t113 * t112;
    let t115 = t24.add_product(t105, t102);
    let t116 = t115 * t112;
    let t117 = (t85 * t82).sub_product(t96, t93).sub_product(t107, t102);
    let t118 = t117 * t112;
    let t119 = (t87 * t82).sub_product(t98, t93).sub_product(t109, t102);
    let t120 = t119 * t112;
    let t121 = (t89 * t82).sub_product(t100, t93).sub_product(t111, t102);
    let t122 = t121 * t112;
    let t123 = R::literal(1.0) / R::literal(5.0).add_product(t25, t6).add_product(t104, t25)
        .add_product(t114, t113);
    let t124 = (t26 * t6).add_product(t105, t25).add_product(t116, t113);
    let t125 = t124 * t123;
    let t126 = (t107 * t25).sub_product(t118, t113);
    let t127 = t126 * t123;
    let t128 = (t109 * t25).sub_product(t120, t113);
    let t129 = t128 * t123;
    let t130 = (t111 * t25).sub_product(t122, t113);
    let t131 = t130 * t123;
    let t132 = R::literal(1.0) / (-R::literal(5.0).add_product(t26, R::literal(0.06) * cos_rod_phi)
        .add_product(t105, t26).add_product(t116, t115)).add_product(t125, t124);
    let t133 = (-(t107 * t26)).add_product(t118, t115).add_product(t127, t124);
    let t134 = t133 * t132;
    let t135 = (-(t109 * t26)).add_product(t120, t115).add_product(t129, t124);
    let t136 = t135 * t132;
    let t137 = (-(t111 * t26)).add_product(t122, t115).add_product(t131, t124);
    let t138 = t137 * t132;
    let t139 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t16, t9)
        + inverse_bobbin_mass).add_product(t58, t57).add_product(t71, t70)).add_product(t85, t84)
        .sub_product(t96, t95).sub_product(t107, t106).sub_product(t118, t117).add_product(t127,
        t126).sub_product(t134, t133);
    let t140 = (t17 * t9).add_product(t60, t57).add_product(t74, t70).add_product(t87, t84)
        .sub_product(t98, t95).sub_product(t109, t106).sub_product(t120, t117).add_product(t129,
        t126).sub_product(t136, t133);
    let t141 = t140 * t139;
    let t142 = t27 * t139;
    let t143 = (t62 * t57).add_product(t76, t70).add_product(t89, t84).sub_product(t100, t95)
        .sub_product(t111, t106).sub_product(t122, t117).add_product(t131, t126).sub_product(t138,
        t133);
    let t144 = t143 * t139;
    let t145 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + inverse_bobbin_mass).add_product(t60, t59).add_product(t74, t73)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135).sub_product(t141, t140);
    let t146 = (-t28).add_product(t142, t140);
    let t147 = t146 * t145;
    let t148 = (-(t62 * t59).add_product(t76, t73)).add_product(t89, t86).sub_product(t100, t97)
        .sub_product(t111, t108).sub_product(t122, t119).add_product(t131, t128).sub_product(t138,
        t135).sub_product(t144, t140);
    let t149 = t148 * t145;
    let t150 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6)
        * bobbin_x_minus_drum_x_over_between;
    let t151 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6)
        * bobbin_y_minus_drum_y_over_between;
    let t152 = R::literal(1.0) / (t150 - ((t27 * bobbin_x_minus_drum_x_over_between)
        .add_product(t28, bobbin_y_minus_drum_y_over_between) + t150 + t151).add_product(t142, t27)
        .add_product(t147, t146) + t151);
    let t153 = (t144 * t27).sub_product(t149, t146);
    let t154 = t153 * t152;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t155 = R::literal(50.0) * slide_rate;
    let t156 = p.spring_stiffness * (slide - p.spring_free_length);
    let t157 = (t156 * cos_cylinder_phi).add_product(t155, cos_cylinder_phi);
    let t158 = t156 * sin_cylinder_phi;
    let t159 = t155 * sin_cylinder_phi;
    let t160 = t159 - (R::literal(2.943) - t158);
    let t161 = (t156 * t7).add_product(t155, t7);
    let t162 = t159 + (R::literal(1.962) + t158);
    let t163 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t164 = (p.winding_force * bobbin_x_minus_drum_x / between).sub_product(R::literal(9.81),
        p.bobbin_mass);
    let post_omega_squared = post_omega * post_omega;
    let t165 = R::literal(0.1) * post_omega_squared;
    let t166 = t165 * cos_post_phi;
    let t167 = t165 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t168 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t169 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t170 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t171 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t172 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t173 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t174 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t175 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t176 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t177 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t178 = (bobbin_v_x * (bobbin_v_x_over_between + t172 + t173 - t170 - t171
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t176 + t177
        - t174 - t175 - drum_v_y_over_between).add_product(drum_v_x, t170 + t171
        + drum_v_x_over_between - bobbin_v_x_over_between - t172 - t173).add_product(drum_v_y, t174
        + t175 + drum_v_y_over_between - bobbin_v_y_over_between - t176 - t177);
    let t179 = t33 * t166;
    let t180 = R::literal(9.81) - t167 - t179;
    let t181 = t14 * bobbin_radius_times_winding_force;
    let t182 = (t181 - t166.add_product(t168, cos_plate_phi)).sub_product(t35, t166)
        .sub_product(t43, t180);
    let t183 = t15 * bobbin_radius_times_winding_force;
    let t184 = (R::literal(9.81) - (t167.add_product(t168, sin_plate_phi) + R::literal(9.81))
        - t183 - t179).sub_product(t45, t180).sub_product(t52, t182);
    let t185 = t181.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .sub_product(R::literal(3.333_333_333_333_333_5), t157).add_product(t20, t161)
        .sub_product(t54, t182).sub_product(t66, t184);
    let t186 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t183)
        .add_product(R::literal(3.333_333_333_333_333_5), t160).add_product(t21, t161)
        .add_product(t55, t182).add_product(t68, t184)).add_product(t79, t185);
    let t187 = (R::literal(-2_777.777_777_777_778) * t161).sub_product(t81, t185).sub_product(t92,
        t186);
    let t188 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t157)
        .add_product(t19, t160).sub_product(t22, t161).sub_product(t23, t157).add_product(t24, t162)
        .add_product(t83, t185).sub_product(t94, t186);
    let t189 = t188.add_product(t103, t187);
    let t190 = (t169 * cos_rod_phi).add_product(R::literal(5.0), t157).sub_product(t104, t187)
        .sub_product(t114, t189);
    let t191 = (t169 * sin_rod_phi).add_product(R::literal(5.0), t162).add_product(t105, t187)
        .add_product(t116, t189).add_product(t125, t190);
    let t192 = (t10 * plate_omega_squared).sub_product(t16, bobbin_radius_times_winding_force)
        .add_product(inverse_bobbin_mass, t163).sub_product(t58, t182).add_product(t71, t184)
        .add_product(t85, t185).sub_product(t96, t186).add_product(t107, t187).sub_product(t118,
        t189).add_product(t127, t190).sub_product(t134, t191);
    let t193 = R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        bobbin_radius_times_winding_force).sub_product(inverse_bobbin_mass, t164).add_product(t60,
        t182).sub_product(t74, t184).add_product(t87, t185).sub_product(t98, t186)
        .add_product(t109, t187).sub_product(t120, t189).add_product(t129, t190).sub_product(t136,
        t191).sub_product(t141, t192);
    let t194 = (-t178).add_product(t27, t163).sub_product(t28, t164)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t142, t192).sub_product(t147, t193)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t195 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t37, t166).sub_product(t47, t180).add_product(t62, t182)
        .sub_product(t76, t184).add_product(t89, t185).sub_product(t100, t186).add_product(t111,
        t187).sub_product(t122, t189).add_product(t131, t190).sub_product(t138, t191)
        .sub_product(t144, t192).sub_product(t149, t193).sub_product(t154, t194);
    let t196 = t195 * (R::literal(1.0) / (-(t13 * t8)).add_product(t37, t36).sub_product(t47, t46)
        .sub_product(t62, t61).sub_product(t76, t75).add_product(t89, t88).sub_product(t100, t99)
        .sub_product(t111, t110).sub_product(t122, t121).add_product(t131, t130).sub_product(t138,
        t137).sub_product(t144, t143).sub_product(t149, t148).sub_product(t154, t153));
    let contact = (-(t194 * t152)).add_product(t154, t196);
    let stop = -t196;
    Outputs {
        contact_force: contact,
        stop_force: stop,
        strut_push: -(t155 + t156),
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 1074 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
        rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y, post_omega,
        plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
        rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
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
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t7 = (rod_y_minus_cylinder_y * cos_cylinder_phi).sub_product(rod_x_minus_cylinder_x,
        sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi).add_product(cylinder_omega, t7)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t8 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t9 = (R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi);
    let t10 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t11 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t12 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t13 = t8 * R::literal(370.370_370_370_370_3);
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = t9 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t19 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t21 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t22 = slide * R::literal(2_777.777_777_777_778);
    let t23 = sin_cylinder_phi * R::literal(5.0);
    let t24 = cos_cylinder_phi * R::literal(5.0);
    let t25 = R::literal(250.0) * sin_rod_phi;
    let t26 = R::literal(250.0) * cos_rod_phi;
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t27 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t28 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t29 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t30 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = t11 * t1;
    let t32 = R::literal(1.25) + t31;
    let t33 = R::literal(1.0) / t32;
    let t34 = t12 * t1;
    let t35 = t34 * t33;
    let t36 = R::literal(1.25) - t31;
    let t37 = t36 * t33;
    let t38 = t13 * t1;
    let t39 = t38 * t33;
    let t40 = t12 * t0;
    let t41 = R::literal(1.25) + t40;
    let t42 = t35 * t34;
    let t43 = R::literal(1.0) / (t42 - t41);
    let t44 = (t11 * t0).add_product(t37, t34);
    let t45 = t44 * t43;
    let t46 = R::literal(1.25) - t40 + t42;
    let t47 = t46 * t43;
    let t48 = (t13 * t0).sub_product(t39, t34);
    let t49 = t48 * t43;
    let t50 = t14 * t3;
    let t51 = R::literal(1.0) / (-(t32 + R::literal(0.833_333_333_333_333_4) + t50))
        .add_product(t37, t36).sub_product(t45, t44);
    let t52 = t15 * t3;
    let t53 = (t34 + t52).add_product(t35, t36).sub_product(t47, t44);
    let t54 = t53 * t51;
    let t55 = R::literal(0.833_333_333_333_333_4) - t50;
    let t56 = t55 * t51;
    let t57 = t52 * t51;
    let t58 = t16 * t3;
    let t59 = R::literal(0.833_333_333_333_333_4) + t58;
    let t60 = t59 * t51;
    let t61 = t17 * t3;
    let t62 = t61 * t51;
    let t63 = t38.add_product(t39, t36).add_product(t49, t44);
    let t64 = t63 * t51;
    let t65 = t15 * t2;
    let t66 = R::literal(1.0) / (t42 - (t41 + R::literal(0.833_333_333_333_333_4) + t65))
        .sub_product(t47, t46).sub_product(t54, t53);
    let t67 = (t14 * t2).sub_product(t56, t53);
    let t68 = t67 * t66;
    let t69 = (R::literal(0.833_333_333_333_333_4) - t65).sub_product(t57, t53);
    let t70 = t69 * t66;
    let t71 = t16 * t2;
    let t72 = t71.add_product(t60, t53);
    let t73 = t72 * t66;
    let t74 = t17 * t2;
    let t75 = (R::literal(0.833_333_333_333_333_4) + t74).add_product(t62, t53);
    let t76 = t75 * t66;
    let t77 = t48.sub_product(t49, t46).add_product(t64, t53);
    let t78 = t77 * t66;
    let t79 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t50
        + R::literal(3.333_333_333_333_333_5)).add_product(t20, t5).add_product(t56, t55)
        .add_product(t68, t67);
    let t80 = t52.add_product(t21, t5).sub_product(t57, t55).sub_product(t70, t67);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = (-t18).add_product(t22, t5);
    let t85 = t84 * t79;
    let t86 = (t58 - R::literal(0.833_333_333_333_333_4)).sub_product(t60, t55).add_product(t73,
        t67);
    let t87 = t86 * t79;
    let t88 = (-t61).add_product(t62, t55).sub_product(t76, t67);
    let t89 = t88 * t79;
    let t90 = (t64 * t55).sub_product(t78, t67);
    let t91 = t90 * t79;
    let t92 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t65
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t4).add_product(t57, t52)
        .add_product(t70, t69)).add_product(t81, t80);
    let t93 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).sub_product(t83, t80);
    let t94 = t93 * t92;
    let t95 = t19.sub_product(t22, t4).add_product(t85, t80);
    let t96 = t95 * t92;
    let t97 = (-t71.add_product(t60, t52)).add_product(t73, t69).add_product(t87, t80);
    let t98 = t97 * t92;
    let t99 = (t74 - R::literal(0.833_333_333_333_333_4)).add_product(t62, t52).sub_product(t76,
        t69).add_product(t89, t80);
    let t100 = t99 * t92;
    let t101 = (t64 * t52).sub_product(t78, t69).add_product(t91, t80);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t83, t82)
        .sub_product(t94, t93);
    let t104 = t22.add_product(t85, t82).add_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t25 * t103;
    let t107 = t26 * t103;
    let t108 = (t87 * t82).add_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t82).add_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t82).add_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t18 * sin_cylinder_phi).add_product(t19, cos_cylinder_phi)
        .add_product(t22, slide).add_product(t23, sin_cylinder_phi).add_product(t24,
        cos_cylinder_phi)).add_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t23.add_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = t24.add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (t87 * t84).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (t89 * t84).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (t91 * t84).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(5.0).add_product(t25, t6).add_product(t106, t25)
        .add_product(t116, t115);
    let t126 = (t26 * t6).add_product(t107, t25).add_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (t109 * t25).sub_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (t111 * t25).sub_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (t113 * t25).sub_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / (-R::literal(5.0).add_product(t26, R::literal(0.06) * cos_rod_phi)
        .add_product(t107, t26).add_product(t118, t117)).add_product(t127, t126);
    let t135 = (-(t109 * t26)).add_product(t120, t117).add_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (-(t111 * t26)).add_product(t122, t117).add_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (-(t113 * t26)).add_product(t124, t117).add_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t16, t9)
        + inverse_bobbin_mass).add_product(t60, t59).add_product(t73, t72)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t17 * t9).add_product(t62, t59).add_product(t76, t72).add_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).add_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t27 * t141;
    let t145 = (t64 * t59).add_product(t78, t72).add_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).add_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + inverse_bobbin_mass).add_product(t62, t61).add_product(t76, t75)).add_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).add_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t28).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (-(t64 * t61).add_product(t78, t75)).add_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).add_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t29 * bobbin_x_minus_drum_x_over_between;
    let t153 = t30 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (t152 - ((t27 * bobbin_x_minus_drum_x_over_between)
        .add_product(t28, bobbin_y_minus_drum_y_over_between) + t152 + t153).add_product(t144, t27)
        .add_product(t149, t148) + t153);
    let t155 = (t146 * t27).sub_product(t151, t148);
    let t156 = t155 * t154;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t157 = R::literal(50.0) * slide_rate;
    let t158 = p.spring_stiffness * (slide - p.spring_free_length);
    let t159 = t158 * cos_cylinder_phi;
    let t160 = t159.add_product(t157, cos_cylinder_phi);
    let t161 = t158 * sin_cylinder_phi;
    let t162 = R::literal(2.943) - t161;
    let t163 = t157 * sin_cylinder_phi;
    let t164 = t163 - t162;
    let t165 = t158 * t7;
    let t166 = t165.add_product(t157, t7);
    let t167 = R::literal(1.962) + t161;
    let t168 = t163 + t167;
    let t169 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t170 = R::literal(9.81) * p.bobbin_mass;
    let t171 = p.winding_force * bobbin_x_minus_drum_x / between - t170;
    let post_omega_squared = post_omega * post_omega;
    let t172 = R::literal(0.1) * post_omega_squared;
    let t173 = t172 * cos_post_phi;
    let t174 = t172 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t175 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t176 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t177 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t178 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t179 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t180 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t181 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t182 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t183 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t184 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t185 = (bobbin_v_x * (bobbin_v_x_over_between + t179 + t180 - t177 - t178
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t183 + t184
        - t181 - t182 - drum_v_y_over_between).add_product(drum_v_x, t177 + t178
        + drum_v_x_over_between - bobbin_v_x_over_between - t179 - t180).add_product(drum_v_y, t181
        + t182 + drum_v_y_over_between - bobbin_v_y_over_between - t183 - t184);
    let t186 = t35 * t173;
    let t187 = R::literal(9.81) - t174 - t186;
    let t188 = t14 * bobbin_radius_times_winding_force;
    let t189 = (t188 - t173.add_product(t175, cos_plate_phi)).sub_product(t37, t173)
        .sub_product(t45, t187);
    let t190 = t15 * bobbin_radius_times_winding_force;
    let t191 = (R::literal(9.81) - (t174.add_product(t175, sin_plate_phi) + R::literal(9.81))
        - t190 - t186).sub_product(t47, t187).sub_product(t54, t189);
    let t192 = R::literal(3.333_333_333_333_333_5) * t160;
    let t193 = (t188.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) - t192).add_product(t20, t166)
        .sub_product(t56, t189).sub_product(t68, t191);
    let t194 = R::literal(3.333_333_333_333_333_5) * t164;
    let t195 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t190 + t194)
        .add_product(t21, t166).add_product(t57, t189).add_product(t70, t191)).add_product(t81,
        t193);
    let t196 = (R::literal(-2_777.777_777_777_778) * t166).sub_product(t83, t193).sub_product(t94,
        t195);
    let t197 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t160)
        .add_product(t19, t164).sub_product(t22, t166).sub_product(t23, t160).add_product(t24, t168)
        .add_product(t85, t193).sub_product(t96, t195);
    let t198 = t197.add_product(t105, t196);
    let t199 = R::literal(5.0) * t160;
    let t200 = t199.add_product(t176, cos_rod_phi).sub_product(t106, t196).sub_product(t116, t198);
    let t201 = R::literal(5.0) * t168;
    let t202 = t201.add_product(t176, sin_rod_phi).add_product(t107, t196).add_product(t118, t198)
        .add_product(t127, t200);
    let t203 = inverse_bobbin_mass * t169;
    let t204 = ((t10 * plate_omega_squared).sub_product(t16, bobbin_radius_times_winding_force)
        + t203).sub_product(t60, t189).add_product(t73, t191).add_product(t87, t193)
        .sub_product(t98, t195).add_product(t109, t196).sub_product(t120, t198).add_product(t129,
        t200).sub_product(t136, t202);
    let t205 = inverse_bobbin_mass * t171;
    let t206 = (R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        bobbin_radius_times_winding_force) - t205).add_product(t62, t189).sub_product(t76, t191)
        .add_product(t89, t193).sub_product(t100, t195).add_product(t111, t196).sub_product(t122,
        t198).add_product(t131, t200).sub_product(t138, t202).sub_product(t143, t204);
    let t207 = (-t185).add_product(t27, t169).sub_product(t28, t171)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t144, t204).sub_product(t149, t206)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t208 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t39, t173).sub_product(t49, t187).add_product(t64, t189)
        .sub_product(t78, t191).add_product(t91, t193).sub_product(t102, t195).add_product(t113,
        t196).sub_product(t124, t198).add_product(t133, t200).sub_product(t140, t202)
        .sub_product(t146, t204).sub_product(t151, t206).sub_product(t156, t207);
    let t209 = t208 * (R::literal(1.0) / (-(t13 * t8)).add_product(t39, t38).sub_product(t49, t48)
        .sub_product(t64, t63).sub_product(t78, t77).add_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).add_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155));
    let t210 = (t207 * t154).sub_product(t156, t209);
    let t211 = (t206 * t147).sub_product(t149, t210).sub_product(t151, t209);
    let t212 = (t204 * t141).sub_product(t143, t211).add_product(t144, t210).sub_product(t146,
        t209);
    let t213 = (t202 * t134).sub_product(t136, t212).sub_product(t138, t211).sub_product(t140,
        t209);
    let t214 = (-(t200 * t125)).add_product(t127, t213).add_product(t129, t212).add_product(t131,
        t211).add_product(t133, t209);
    let t215 = (t198 * t114).sub_product(t116, t214).add_product(t118, t213).sub_product(t120, t212)
        .sub_product(t122, t211).sub_product(t124, t209);
    let t216 = (t196 * t103).add_product(t105, t215).sub_product(t106, t214).add_product(t107, t213)
        .add_product(t109, t212).add_product(t111, t211).add_product(t113, t209);
    let t217 = (t195 * t92).sub_product(t94, t216).sub_product(t96, t215).sub_product(t98, t212)
        .sub_product(t100, t211).sub_product(t102, t209);
    let t218 = (-(t193 * t79)).add_product(t81, t217).sub_product(t83, t216).add_product(t85, t215)
        .add_product(t87, t212).add_product(t89, t211).add_product(t91, t209);
    let t219 = (t191 * t66).sub_product(t68, t218).sub_product(t70, t217).add_product(t73, t212)
        .sub_product(t76, t211).sub_product(t78, t209);
    let t220 = (t189 * t51).sub_product(t54, t219).sub_product(t56, t218).sub_product(t57, t217)
        .sub_product(t60, t212).add_product(t62, t211).add_product(t64, t209);
    let t221 = (t187 * t43).sub_product(t45, t220).sub_product(t47, t219).sub_product(t49, t209);
    let t222 = (t173 * t33).add_product(t35, t221).add_product(t37, t220).add_product(t35, t219)
        .sub_product(t39, t209);
    let drum_v_y_dot = (-R::literal(9.809_999_999_999_999)
        .add_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t210))).add_product(t30, t210);
    let drum_v_x_dot = (t29 * t210).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t210);
    let bobbin_v_y_dot = t205.sub_product(inverse_bobbin_mass, t211).sub_product(t28, t210);
    let rod_omega_dot = (t25 * t214).sub_product(R::literal(4_166.666_666_666_667), t216)
        .sub_product(t26, t213);
    let rod_v_x_dot = (-t199).add_product(t23, t215).sub_product(R::literal(5.0), t214);
    let cylinder_omega_dot = (-(t166 * R::literal(2_777.777_777_777_778)).add_product(t20, t218))
        .add_product(t21, t217).sub_product(R::literal(-2_777.777_777_777_778), t216)
        .add_product(t22, t215);
    let cylinder_v_y_dot = t194.sub_product(R::literal(3.333_333_333_333_333_5), t217)
        .add_product(t19, t215);
    let cylinder_v_x_dot = t192.sub_product(R::literal(3.333_333_333_333_333_5), t218)
        .sub_product(t18, t215);
    let plate_omega_dot = (-(bobbin_radius_times_winding_force * R::literal(400.0))
        .add_product(t14, t220)).add_product(t15, t219).sub_product(t14, t218).add_product(t15,
        t217).add_product(t16, t212).sub_product(t17, t211);
    let post_omega_dot = (t12 * t221).sub_product(t11, t222).sub_product(t11, t220)
        .add_product(t12, t219).sub_product(t13, t209);
    let t223 = (R::literal(7.848) * post_v_y).add_product(R::literal(11.772), plate_v_y)
        .sub_product(t159, cylinder_v_x).add_product(t162, cylinder_v_y).add_product(t165,
        cylinder_omega).add_product(t159, rod_v_x).add_product(t167, rod_v_y).add_product(t170,
        bobbin_v_y).add_product(R::literal(14.715), drum_v_y).sub_product(R::literal(0.8)
        * post_v_x, (R::literal(-1.25) * t220).add_product(R::literal(1.25), t222))
        .sub_product(R::literal(0.8) * post_v_y, R::literal(9.81).add_product(R::literal(1.25),
        t221).add_product(R::literal(-1.25), t219)).add_product(R::literal(0.0027) * post_omega,
        post_omega_dot).sub_product(R::literal(1.2) * plate_v_x,
        (R::literal(-0.833_333_333_333_333_4) * t218)
        .add_product(R::literal(0.833_333_333_333_333_4), t220)
        .add_product(R::literal(-0.833_333_333_333_333_4), t212));
    let t224 = t223.sub_product(R::literal(1.2) * plate_v_y, R::literal(9.81)
        .add_product(R::literal(0.833_333_333_333_333_4), t219)
        .add_product(R::literal(-0.833_333_333_333_333_4), t217)
        .add_product(R::literal(-0.833_333_333_333_333_4), t211)).add_product(R::literal(0.0025)
        * plate_omega, plate_omega_dot).add_product(R::literal(0.3) * cylinder_v_x,
        cylinder_v_x_dot).add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
        .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
        .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot).sub_product(R::literal(0.2) * rod_v_y,
        t201.add_product(t24, t215).add_product(R::literal(5.0), t213))
        .add_product(R::literal(0.00024) * rod_omega, rod_omega_dot);
    PowerBalance {
        stored_rate: t224.sub_product(p.bobbin_mass * bobbin_v_x, t203
            .add_product(inverse_bobbin_mass, t212).add_product(t27, t210))
            .add_product(p.bobbin_mass * bobbin_v_y, bobbin_v_y_dot).add_product(R::literal(1.5)
            * drum_v_x, drum_v_x_dot).add_product(R::literal(1.5) * drum_v_y, drum_v_y_dot),
        supplied: (p.winding_force * bobbin_v_y * bobbin_x_minus_drum_x / between)
            .sub_product(bobbin_radius_times_winding_force, plate_omega) - p.winding_force
            * bobbin_v_x * bobbin_y_minus_drum_y / between,
        dissipated: (R::literal(50.0) * cylinder_omega * slide_rate * t7)
            .add_product(R::literal(50.0) * rod_v_x * slide_rate, cos_cylinder_phi)
            .add_product(R::literal(50.0) * rod_v_y * slide_rate, sin_cylinder_phi)
            .sub_product(R::literal(50.0) * cylinder_v_x * slide_rate, cos_cylinder_phi)
            .sub_product(R::literal(50.0) * cylinder_v_y * slide_rate, sin_cylinder_phi),
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
