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
// Operations: rate 982, forcing 50, rate_jacobian 7233, parameter_jacobian 2133, outputs 780,
//     energy 72, power_balance 1073, constraint_values 62, constraint_rates 89, constraint_matrix 43,
//     prepare 4, prepared_rate 978, prepared_rate_jacobian 7229.

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
    let t9 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t10 = R::literal(0.01) * t9;
    let t11 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t13 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t14 = t8 * R::literal(370.370_370_370_370_3);
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = R::literal(4.0) * t9;
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
    let t28 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(1.25) + t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(1.25) + t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t43 - t42);
    let t45 = (t12 * t0).add_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 + t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).sub_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0) / (-(t33 + R::literal(0.833_333_333_333_333_4) + t51))
        .add_product(t38, t37).sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).add_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t39.add_product(t40, t37).add_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0) / (t43 - (t42 + R::literal(0.833_333_333_333_333_4) + t66))
        .sub_product(t48, t47).sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = t17 * t2;
    let t73 = t72.add_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).add_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t51
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t5).add_product(t57, t56)
        .add_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = t21 * t80;
    let t84 = (-t19).add_product(t23, t5);
    let t85 = t84 * t80;
    let t86 = (t59 - R::literal(0.833_333_333_333_333_4)).sub_product(t61, t56).add_product(t74,
        t68);
    let t87 = t86 * t80;
    let t88 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t89 = t88 * t80;
    let t90 = (t65 * t56).sub_product(t79, t68);
    let t91 = t90 * t80;
    let t92 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t66
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t58, t53)
        .add_product(t71, t70)).add_product(t82, t81);
    let t93 = (-t22).add_product(t83, t81);
    let t94 = t93 * t92;
    let t95 = t20.sub_product(t23, t4).add_product(t85, t81);
    let t96 = t95 * t92;
    let t97 = (-t72.add_product(t61, t53)).add_product(t74, t70).add_product(t87, t81);
    let t98 = t97 * t92;
    let t99 = (t75 - R::literal(0.833_333_333_333_333_4)).add_product(t63, t53).sub_product(t77,
        t70).add_product(t89, t81);
    let t100 = t99 * t92;
    let t101 = (t65 * t53).sub_product(t79, t70).add_product(t91, t81);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t83, t21)
        .sub_product(t94, t93);
    let t104 = (-t23).add_product(t85, t21).sub_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t26 * t103;
    let t107 = t27 * t103;
    let t108 = (t87 * t21).sub_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t21).sub_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t21).sub_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t24.sub_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = (-t25).add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (t87 * t84).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (t89 * t84).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (t91 * t84).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t106, t26)
        .add_product(t116, t115);
    let t126 = (t27 * t6).add_product(t107, t26).sub_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (t109 * t26).add_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (t111 * t26).add_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (t113 * t26).add_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t107, t27).add_product(t118, t117)).add_product(t127, t126);
    let t135 = (t109 * t27).sub_product(t120, t117).sub_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (t111 * t27).sub_product(t122, t117).sub_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (t113 * t27).sub_product(t124, t117).sub_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + c.inverse_bobbin_mass).add_product(t61, t60).add_product(t74, t73)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t18 * t10).add_product(t63, t60).add_product(t77, t73).add_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).add_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t28 * t141;
    let t145 = (t65 * t60).add_product(t79, t73).add_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).add_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t11)
        + c.inverse_bobbin_mass).add_product(t63, t62).add_product(t77, t76)).add_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).add_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t29).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (-(t65 * t62).add_product(t79, t76)).add_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).add_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t30 * bobbin_x_minus_drum_x_over_between;
    let t153 = t31 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (t152 - ((t28 * bobbin_x_minus_drum_x_over_between)
        .add_product(t29, bobbin_y_minus_drum_y_over_between) + t152 + t153).add_product(t144, t28)
        .add_product(t149, t148) + t153);
    let t155 = (t146 * t28).sub_product(t151, t148);
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
    let t181 = t36 * t168;
    let t182 = R::literal(9.81) - t169 - t181;
    let t183 = t15 * c.bobbin_radius_times_winding_force;
    let t184 = (t183 - t168.add_product(t170, cos_plate_phi)).sub_product(t38, t168)
        .sub_product(t46, t182);
    let t185 = t16 * c.bobbin_radius_times_winding_force;
    let t186 = (R::literal(9.81) - (t169.add_product(t170, sin_plate_phi) + R::literal(9.81))
        - t185 - t181).sub_product(t48, t182).sub_product(t55, t184);
    let t187 = R::literal(3.333_333_333_333_333_5) * t159;
    let t188 = (t183.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) - t187).add_product(t21, t163)
        .sub_product(t57, t184).sub_product(t69, t186);
    let t189 = R::literal(3.333_333_333_333_333_5) * t162;
    let t190 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t185 + t189)
        .add_product(t22, t163).add_product(t58, t184).add_product(t71, t186)).add_product(t82,
        t188);
    let t191 = R::literal(2_777.777_777_777_778) * t163;
    let t192 = (-t191).add_product(t83, t188).sub_product(t94, t190);
    let t193 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t159)
        .add_product(t20, t162).sub_product(t23, t163).sub_product(t24, t159).add_product(t25, t164)
        .add_product(t85, t188).sub_product(t96, t190);
    let t194 = t193.sub_product(t105, t192);
    let t195 = R::literal(5.0) * t159;
    let t196 = t195.add_product(t171, cos_rod_phi).sub_product(t106, t192).sub_product(t116, t194);
    let t197 = R::literal(5.0) * t164;
    let t198 = t197.add_product(t171, sin_rod_phi).add_product(t107, t192).sub_product(t118, t194)
        .add_product(t127, t196);
    let t199 = c.inverse_bobbin_mass * t165;
    let t200 = ((t11 * plate_omega_squared).sub_product(t17, c.bobbin_radius_times_winding_force)
        + t199).sub_product(t61, t184).add_product(t74, t186).add_product(t87, t188)
        .sub_product(t98, t190).sub_product(t109, t192).sub_product(t120, t194).sub_product(t129,
        t196).sub_product(t136, t198);
    let t201 = c.inverse_bobbin_mass * t166;
    let t202 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared).add_product(t18,
        c.bobbin_radius_times_winding_force) - t201).add_product(t63, t184).sub_product(t77, t186)
        .add_product(t89, t188).sub_product(t100, t190).sub_product(t111, t192).sub_product(t122,
        t194).sub_product(t131, t196).sub_product(t138, t198).sub_product(t143, t200);
    let t203 = R::literal(9.809_999_999_999_999) * bobbin_y_minus_drum_y_over_between;
    let t204 = ((-t180).add_product(t28, t165).sub_product(t29, t166) - t203).add_product(t144,
        t200).sub_product(t149, t202) + t203;
    let t205 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t40, t168).sub_product(t50, t182).add_product(t65, t184)
        .sub_product(t79, t186).add_product(t91, t188).sub_product(t102, t190).sub_product(t113,
        t192).sub_product(t124, t194).sub_product(t133, t196).sub_product(t140, t198)
        .sub_product(t146, t200).sub_product(t151, t202).sub_product(t156, t204);
    let t206 = t205 * (R::literal(1.0) / (-(t14 * t8)).add_product(t40, t39).sub_product(t50, t49)
        .sub_product(t65, t64).sub_product(t79, t78).add_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).add_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155));
    let t207 = (t204 * t154).sub_product(t156, t206);
    let t208 = (t202 * t147).sub_product(t149, t207).sub_product(t151, t206);
    let t209 = (t200 * t141).sub_product(t143, t208).add_product(t144, t207).sub_product(t146,
        t206);
    let t210 = (t198 * t134).sub_product(t136, t209).sub_product(t138, t208).sub_product(t140,
        t206);
    let t211 = (-(t196 * t125)).add_product(t127, t210).sub_product(t129, t209).sub_product(t131,
        t208).sub_product(t133, t206);
    let t212 = (t194 * t114).sub_product(t116, t211).sub_product(t118, t210).sub_product(t120, t209)
        .sub_product(t122, t208).sub_product(t124, t206);
    let t213 = (t192 * t103).sub_product(t105, t212).sub_product(t106, t211).add_product(t107, t210)
        .sub_product(t109, t209).sub_product(t111, t208).sub_product(t113, t206);
    let t214 = (t190 * t92).sub_product(t94, t213).sub_product(t96, t212).sub_product(t98, t209)
        .sub_product(t100, t208).sub_product(t102, t206);
    let t215 = (-(t188 * t80)).add_product(t82, t214).add_product(t83, t213).add_product(t85, t212)
        .add_product(t87, t209).add_product(t89, t208).add_product(t91, t206);
    let t216 = (t186 * t67).sub_product(t69, t215).sub_product(t71, t214).add_product(t74, t209)
        .sub_product(t77, t208).sub_product(t79, t206);
    let t217 = (t184 * t52).sub_product(t55, t216).sub_product(t57, t215).sub_product(t58, t214)
        .sub_product(t61, t209).add_product(t63, t208).add_product(t65, t206);
    let t218 = (t182 * t44).sub_product(t46, t217).sub_product(t48, t216).sub_product(t50, t206);
    let t219 = (t168 * t34).add_product(t36, t218).add_product(t38, t217).add_product(t36, t216)
        .sub_product(t40, t206);
    let drum_v_y_dot = (-R::literal(9.809_999_999_999_999)
        .add_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t207))).add_product(t31, t207);
    let drum_v_x_dot = (t30 * t207).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t207);
    let bobbin_v_y_dot = t201.sub_product(c.inverse_bobbin_mass, t208).sub_product(t29, t207);
    let bobbin_v_x_dot = -t199.add_product(c.inverse_bobbin_mass, t209).add_product(t28, t207);
    let rod_omega_dot = (t26 * t211).sub_product(R::literal(4_166.666_666_666_667), t213)
        .sub_product(t27, t210);
    let rod_v_y_dot = -t197.add_product(t25, t212).add_product(R::literal(5.0), t210);
    let rod_v_x_dot = (-t195).add_product(t24, t212).sub_product(R::literal(5.0), t211);
    let cylinder_omega_dot = (-t191.add_product(t21, t215)).add_product(t22, t214)
        .add_product(R::literal(2_777.777_777_777_778), t213).add_product(t23, t212);
    let cylinder_v_y_dot = t189.sub_product(R::literal(3.333_333_333_333_333_5), t214)
        .add_product(t20, t212);
    let cylinder_v_x_dot = t187.sub_product(R::literal(3.333_333_333_333_333_5), t215)
        .sub_product(t19, t212);
    let plate_omega_dot = (-c.t1.add_product(t15, t217)).add_product(t16, t216).sub_product(t15,
        t215).add_product(t16, t214).add_product(t17, t209).sub_product(t18, t208);
    let plate_v_y_dot = (-R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t216))
        .add_product(R::literal(0.833_333_333_333_333_4), t214)
        .add_product(R::literal(0.833_333_333_333_333_4), t208);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t215)
        .sub_product(R::literal(0.833_333_333_333_333_4), t217)
        .add_product(R::literal(0.833_333_333_333_333_4), t209);
    let post_omega_dot = (t13 * t218).sub_product(t12, t219).sub_product(t12, t217)
        .add_product(t13, t216).sub_product(t14, t206);
    let post_v_y_dot = (-R::literal(9.81).add_product(R::literal(1.25), t218))
        .add_product(R::literal(1.25), t216);
    let post_v_x_dot = (R::literal(1.25) * t217).sub_product(R::literal(1.25), t219);
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

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 50 operations.
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
    let rod_y_forcing = -(t4 + (R::literal(1.962) + t3));
    let bobbin_x_forcing = -(p.winding_force * bobbin_y_minus_drum_y / between);
    let bobbin_y_forcing = (p.winding_force * bobbin_x_minus_drum_x / between)
        .sub_product(R::literal(9.81), p.bobbin_mass);
    [R::literal(0.0), R::literal(-7.848), R::literal(0.0), R::literal(0.0), R::literal(-11.772),
        plate_phi_forcing, cylinder_x_forcing, cylinder_y_forcing, cylinder_phi_forcing,
        rod_x_forcing, rod_y_forcing, R::literal(0.0), bobbin_x_forcing, bobbin_y_forcing,
        R::literal(0.0), R::literal(0.0), R::literal(-14.715), R::literal(0.0)]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 7229 operations.
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
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t8 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t9 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t10 = t9 - t8;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi).add_product(cylinder_omega,
        t10).add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let t11 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t12 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t13 = R::literal(0.01) * t12;
    let t14 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t15 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t16 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t17 = t11 * R::literal(370.370_370_370_370_3);
    let t18 = R::literal(24.0) * sin_plate_phi;
    let t19 = R::literal(24.0) * cos_plate_phi;
    let t20 = R::literal(4.0) * t12;
    let t21 = t14 * R::literal(400.0);
    let t22 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t23 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t24 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t25 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t26 = slide * R::literal(2_777.777_777_777_778);
    let t27 = sin_cylinder_phi * R::literal(5.0);
    let t28 = cos_cylinder_phi * R::literal(5.0);
    let t29 = R::literal(250.0) * sin_rod_phi;
    let t30 = R::literal(250.0) * cos_rod_phi;
    let t31 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t32 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t33 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t34 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t35 = t15 * t1;
    let t36 = R::literal(1.25) + t35;
    let t37 = R::literal(1.0) / t36;
    let t38 = t16 * t1;
    let t39 = t38 * t37;
    let t40 = R::literal(1.25) - t35;
    let t41 = t40 * t37;
    let t42 = t17 * t1;
    let t43 = t42 * t37;
    let t44 = t16 * t0;
    let t45 = R::literal(1.25) + t44;
    let t46 = t39 * t38;
    let t47 = R::literal(1.0) / (t46 - t45);
    let t48 = (t15 * t0).add_product(t41, t38);
    let t49 = t48 * t47;
    let t50 = R::literal(1.25) - t44 + t46;
    let t51 = t50 * t47;
    let t52 = (t17 * t0).sub_product(t43, t38);
    let t53 = t52 * t47;
    let t54 = t18 * t3;
    let t55 = R::literal(1.0) / (-(t36 + R::literal(0.833_333_333_333_333_4) + t54))
        .add_product(t41, t40).sub_product(t49, t48);
    let t56 = t19 * t3;
    let t57 = (t38 + t56).add_product(t39, t40).sub_product(t51, t48);
    let t58 = t57 * t55;
    let t59 = R::literal(0.833_333_333_333_333_4) - t54;
    let t60 = t59 * t55;
    let t61 = t56 * t55;
    let t62 = t20 * t3;
    let t63 = R::literal(0.833_333_333_333_333_4) + t62;
    let t64 = t63 * t55;
    let t65 = t21 * t3;
    let t66 = t65 * t55;
    let t67 = t42.add_product(t43, t40).add_product(t53, t48);
    let t68 = t67 * t55;
    let t69 = t19 * t2;
    let t70 = R::literal(1.0) / (t46 - (t45 + R::literal(0.833_333_333_333_333_4) + t69))
        .sub_product(t51, t50).sub_product(t58, t57);
    let t71 = (t18 * t2).sub_product(t60, t57);
    let t72 = t71 * t70;
    let t73 = (R::literal(0.833_333_333_333_333_4) - t69).sub_product(t61, t57);
    let t74 = t73 * t70;
    let t75 = t20 * t2;
    let t76 = t75.add_product(t64, t57);
    let t77 = t76 * t70;
    let t78 = t21 * t2;
    let t79 = (R::literal(0.833_333_333_333_333_4) + t78).add_product(t66, t57);
    let t80 = t79 * t70;
    let t81 = t52.sub_product(t53, t50).add_product(t68, t57);
    let t82 = t81 * t70;
    let t83 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t54
        + R::literal(3.333_333_333_333_333_5)).add_product(t24, t5).add_product(t60, t59)
        .add_product(t72, t71);
    let t84 = t56.add_product(t25, t5).sub_product(t61, t59).sub_product(t74, t71);
    let t85 = t84 * t83;
    let t86 = t24 * t83;
    let t87 = (-t22).add_product(t26, t5);
    let t88 = t87 * t83;
    let t89 = (t62 - R::literal(0.833_333_333_333_333_4)).sub_product(t64, t59).add_product(t77,
        t71);
    let t90 = t89 * t83;
    let t91 = (-t65).add_product(t66, t59).sub_product(t80, t71);
    let t92 = t91 * t83;
    let t93 = (t68 * t59).sub_product(t82, t71);
    let t94 = t93 * t83;
    let t95 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t69
        + R::literal(3.333_333_333_333_333_5)).add_product(t25, t4).add_product(t61, t56)
        .add_product(t74, t73)).add_product(t85, t84);
    let t96 = (-t25).add_product(t86, t84);
    let t97 = t96 * t95;
    let t98 = t23.sub_product(t26, t4).add_product(t88, t84);
    let t99 = t98 * t95;
    let t100 = (-t75.add_product(t64, t56)).add_product(t77, t73).add_product(t90, t84);
    let t101 = t100 * t95;
    let t102 = (t78 - R::literal(0.833_333_333_333_333_4)).add_product(t66, t56).sub_product(t80,
        t73).add_product(t92, t84);
    let t103 = t102 * t95;
    let t104 = (t68 * t56).sub_product(t82, t73).add_product(t94, t84);
    let t105 = t104 * t95;
    let t106 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t86, t24)
        .sub_product(t97, t96);
    let t107 = (-t26).add_product(t88, t24).sub_product(t99, t96);
    let t108 = t107 * t106;
    let t109 = t29 * t106;
    let t110 = t30 * t106;
    let t111 = (t90 * t24).sub_product(t101, t96);
    let t112 = t111 * t106;
    let t113 = (t92 * t24).sub_product(t103, t96);
    let t114 = t113 * t106;
    let t115 = (t94 * t24).sub_product(t105, t96);
    let t116 = t115 * t106;
    let t117 = R::literal(1.0) / (-(t22 * sin_cylinder_phi).add_product(t23, cos_cylinder_phi)
        .add_product(t26, slide).add_product(t27, sin_cylinder_phi).add_product(t28,
        cos_cylinder_phi)).add_product(t88, t87).sub_product(t99, t98).sub_product(t108, t107);
    let t118 = t27.sub_product(t109, t107);
    let t119 = t118 * t117;
    let t120 = (-t28).add_product(t110, t107);
    let t121 = t120 * t117;
    let t122 = (t90 * t87).sub_product(t101, t98).sub_product(t112, t107);
    let t123 = t122 * t117;
    let t124 = (t92 * t87).sub_product(t103, t98).sub_product(t114, t107);
    let t125 = t124 * t117;
    let t126 = (t94 * t87).sub_product(t105, t98).sub_product(t116, t107);
    let t127 = t126 * t117;
    let t128 = R::literal(1.0) / R::literal(5.0).add_product(t29, t7).add_product(t109, t29)
        .add_product(t119, t118);
    let t129 = (t30 * t7).add_product(t110, t29).sub_product(t121, t118);
    let t130 = t129 * t128;
    let t131 = (t112 * t29).add_product(t123, t118);
    let t132 = t131 * t128;
    let t133 = (t114 * t29).add_product(t125, t118);
    let t134 = t133 * t128;
    let t135 = (t116 * t29).add_product(t127, t118);
    let t136 = t135 * t128;
    let t137 = R::literal(1.0) / (-R::literal(5.0).add_product(t30, t6).add_product(t110, t30)
        .add_product(t121, t120)).add_product(t130, t129);
    let t138 = (t112 * t30).sub_product(t123, t120).sub_product(t132, t129);
    let t139 = t138 * t137;
    let t140 = (t114 * t30).sub_product(t125, t120).sub_product(t134, t129);
    let t141 = t140 * t137;
    let t142 = (t116 * t30).sub_product(t127, t120).sub_product(t136, t129);
    let t143 = t142 * t137;
    let t144 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t20, t13)
        + c.inverse_bobbin_mass).add_product(t64, t63).add_product(t77, t76)).add_product(t90, t89)
        .sub_product(t101, t100).sub_product(t112, t111).sub_product(t123, t122).add_product(t132,
        t131).sub_product(t139, t138);
    let t145 = (t21 * t13).add_product(t66, t63).add_product(t80, t76).add_product(t92, t89)
        .sub_product(t103, t100).sub_product(t114, t111).sub_product(t125, t122).add_product(t134,
        t131).sub_product(t141, t138);
    let t146 = t145 * t144;
    let t147 = t31 * t144;
    let t148 = (t68 * t63).add_product(t82, t76).add_product(t94, t89).sub_product(t105, t100)
        .sub_product(t116, t111).sub_product(t127, t122).add_product(t136, t131).sub_product(t143,
        t138);
    let t149 = t148 * t144;
    let t150 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t21, t14)
        + c.inverse_bobbin_mass).add_product(t66, t65).add_product(t80, t79)).add_product(t92, t91)
        .sub_product(t103, t102).sub_product(t114, t113).sub_product(t125, t124).add_product(t134,
        t133).sub_product(t141, t140).sub_product(t146, t145);
    let t151 = (-t32).add_product(t147, t145);
    let t152 = t151 * t150;
    let t153 = (-(t68 * t65).add_product(t82, t79)).add_product(t94, t91).sub_product(t105, t102)
        .sub_product(t116, t113).sub_product(t127, t124).add_product(t136, t133).sub_product(t143,
        t140).sub_product(t149, t145);
    let t154 = t153 * t150;
    let t155 = t33 * bobbin_x_minus_drum_x_over_between;
    let t156 = t34 * bobbin_y_minus_drum_y_over_between;
    let t157 = R::literal(1.0) / (t155 - ((t31 * bobbin_x_minus_drum_x_over_between)
        .add_product(t32, bobbin_y_minus_drum_y_over_between) + t155 + t156).add_product(t147, t31)
        .add_product(t152, t151) + t156);
    let t158 = (t149 * t31).sub_product(t154, t151);
    let t159 = t158 * t157;
    let t160 = R::literal(1.0) / (-(t17 * t11)).add_product(t43, t42).sub_product(t53, t52)
        .sub_product(t68, t67).sub_product(t82, t81).add_product(t94, t93).sub_product(t105, t104)
        .sub_product(t116, t115).sub_product(t127, t126).add_product(t136, t135).sub_product(t143,
        t142).sub_product(t149, t148).sub_product(t154, t153).sub_product(t159, t158);
    let t161 = R::literal(50.0) * slide_rate;
    let t162 = t161 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t163 = p.spring_stiffness * slide_minus_spring_free_length;
    let t164 = t163 * cos_cylinder_phi;
    let t165 = t162 + t164;
    let t166 = t163 * sin_cylinder_phi;
    let t167 = t161 * sin_cylinder_phi;
    let t168 = t167 - (R::literal(2.943) - t166);
    let t169 = (t163 * t10).add_product(t161, t10);
    let t170 = t167 + (R::literal(1.962) + t166);
    let t171 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t172 = p.winding_force * bobbin_x_minus_drum_x;
    let t173 = t172 / between - c.t0;
    let post_omega_squared = post_omega * post_omega;
    let t174 = R::literal(0.1) * post_omega_squared;
    let t175 = t174 * cos_post_phi;
    let t176 = t174 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t177 = R::literal(0.06) * plate_omega_squared;
    let t178 = t177 * cos_plate_phi;
    let t179 = t177 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t180 = cylinder_omega_squared * cos_cylinder_phi;
    let t181 = cylinder_omega_squared * sin_cylinder_phi;
    let t182 = R::literal(2.0) * cylinder_v_x;
    let t183 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t184 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t185 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t186 = R::literal(2.0) * rod_v_x;
    let t187 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t188 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t189 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t190 = R::literal(0.06) * (rod_omega * rod_omega);
    let t191 = t190 * cos_rod_phi;
    let t192 = t190 * sin_rod_phi;
    let t193 = t14 * plate_omega_squared;
    let between_squared = between * between;
    let between_squared_times_between = between_squared * between;
    let t194 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t195 = bobbin_v_y * bobbin_x_minus_drum_x;
    let t196 = t195 * bobbin_y_minus_drum_y / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t197 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let drum_v_y_times_bobbin_x_minus_drum_x = drum_v_y * bobbin_x_minus_drum_x;
    let t198 = drum_v_y_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t199 = bobbin_v_x * bobbin_x_minus_drum_x;
    let t200 = t199 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t201 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let drum_v_x_times_bobbin_x_minus_drum_x = drum_v_x * bobbin_x_minus_drum_x;
    let t202 = drum_v_x_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t203 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t204 = (bobbin_v_x * (bobbin_v_x_over_between + t197 + t198 - t194 - t196
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t202 + t203
        - t200 - t201 - drum_v_y_over_between).add_product(drum_v_x, t194 + t196
        + drum_v_x_over_between - bobbin_v_x_over_between - t197 - t198).add_product(drum_v_y, t200
        + t201 + drum_v_y_over_between - bobbin_v_y_over_between - t202 - t203);
    let t205 = (R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi);
    let t206 = t39 * t175;
    let t207 = R::literal(9.81) - t176 - t206;
    let t208 = t18 * c.bobbin_radius_times_winding_force;
    let t209 = (t208 - (t178 + t175)).sub_product(t41, t175).sub_product(t49, t207);
    let t210 = t19 * c.bobbin_radius_times_winding_force;
    let t211 = (R::literal(9.81) - (t179 + t176 + R::literal(9.81)) - t210 - t206).sub_product(t51,
        t207).sub_product(t58, t209);
    let t212 = R::literal(3.333_333_333_333_333_5) * t165;
    let t213 = (t208.sub_product(R::literal(0.06), t180.add_product(plate_omega_squared,
        cos_plate_phi)) - t212).add_product(t24, t169).sub_product(t60, t209).sub_product(t72,
        t211);
    let t214 = R::literal(3.333_333_333_333_333_5) * t168;
    let t215 = (-(R::literal(9.81).add_product(R::literal(0.06), t181
        .add_product(plate_omega_squared, sin_plate_phi)) + t210 + t214).add_product(t25, t169)
        .add_product(t61, t209).add_product(t74, t211)).add_product(t85, t213);
    let t216 = R::literal(2_777.777_777_777_778) * t169;
    let t217 = (-t216).add_product(t86, t213).sub_product(t97, t215);
    let t218 = (cylinder_omega * (((t186 * cos_cylinder_phi).add_product(t187, sin_cylinder_phi)
        + t188 + t189).sub_product(t182, cos_cylinder_phi).sub_product(t183, sin_cylinder_phi)
        - t184 - t185)).sub_product(t22, t165).add_product(t23, t168).sub_product(t26, t169)
        .sub_product(t27, t165).add_product(t28, t170).add_product(t88, t213).sub_product(t99, t215)
        .sub_product(t108, t217);
    let t219 = R::literal(5.0) * t165;
    let t220 = (t191 + t219).sub_product(t109, t217).sub_product(t119, t218);
    let t221 = R::literal(5.0) * t170;
    let t222 = (t192 + t221).add_product(t110, t217).sub_product(t121, t218).add_product(t130,
        t220);
    let t223 = c.inverse_bobbin_mass * t171;
    let t224 = (t193.sub_product(t20, c.bobbin_radius_times_winding_force) + t223).sub_product(t64,
        t209).add_product(t77, t211).add_product(t90, t213).sub_product(t101, t215)
        .sub_product(t112, t217).sub_product(t123, t218).sub_product(t132, t220).sub_product(t139,
        t222);
    let t225 = c.inverse_bobbin_mass * t173;
    let t226 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared).add_product(t21,
        c.bobbin_radius_times_winding_force) - t225).add_product(t66, t209).sub_product(t80, t211)
        .add_product(t92, t213).sub_product(t103, t215).sub_product(t114, t217).sub_product(t125,
        t218).sub_product(t134, t220).sub_product(t141, t222).sub_product(t146, t224);
    let t227 = R::literal(9.809_999_999_999_999) * bobbin_y_minus_drum_y_over_between;
    let t228 = ((-t204).add_product(t31, t171).sub_product(t32, t173) - t227).add_product(t147,
        t224).sub_product(t152, t226) + t227;
    let t229 = (-(t205 * post_omega_squared)).add_product(t43, t175).sub_product(t53, t207)
        .add_product(t68, t209).sub_product(t82, t211).add_product(t94, t213).sub_product(t105,
        t215).sub_product(t116, t217).sub_product(t127, t218).sub_product(t136, t220)
        .sub_product(t143, t222).sub_product(t149, t224).sub_product(t154, t226).sub_product(t159,
        t228) * t160;
    let t230 = (t228 * t157).sub_product(t159, t229);
    let t231 = (t226 * t150).sub_product(t152, t230).sub_product(t154, t229);
    let t232 = (t224 * t144).sub_product(t146, t231).add_product(t147, t230).sub_product(t149,
        t229);
    let t233 = (t222 * t137).sub_product(t139, t232).sub_product(t141, t231).sub_product(t143,
        t229);
    let t234 = (-(t220 * t128)).add_product(t130, t233).sub_product(t132, t232).sub_product(t134,
        t231).sub_product(t136, t229);
    let t235 = (t218 * t117).sub_product(t119, t234).sub_product(t121, t233).sub_product(t123, t232)
        .sub_product(t125, t231).sub_product(t127, t229);
    let t236 = (t217 * t106).sub_product(t108, t235).sub_product(t109, t234).add_product(t110, t233)
        .sub_product(t112, t232).sub_product(t114, t231).sub_product(t116, t229);
    let t237 = (t215 * t95).sub_product(t97, t236).sub_product(t99, t235).sub_product(t101, t232)
        .sub_product(t103, t231).sub_product(t105, t229);
    let t238 = (-(t213 * t83)).add_product(t85, t237).add_product(t86, t236).add_product(t88, t235)
        .add_product(t90, t232).add_product(t92, t231).add_product(t94, t229);
    let t239 = (t211 * t70).sub_product(t72, t238).sub_product(t74, t237).add_product(t77, t232)
        .sub_product(t80, t231).sub_product(t82, t229);
    let t240 = (t209 * t55).sub_product(t58, t239).sub_product(t60, t238).sub_product(t61, t237)
        .sub_product(t64, t232).add_product(t66, t231).add_product(t68, t229);
    let t241 = (t207 * t47).sub_product(t49, t240).sub_product(t51, t239).sub_product(t53, t229);
    let t242 = (t175 * t37).add_product(t39, t241).add_product(t41, t240).add_product(t39, t239)
        .sub_product(t43, t229);
    let drum_v_y_dot = (-R::literal(9.809_999_999_999_999)
        .add_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t230))).add_product(t34, t230);
    let drum_v_x_dot = (t33 * t230).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t230);
    let bobbin_v_y_dot = t225.sub_product(c.inverse_bobbin_mass, t231).sub_product(t32, t230);
    let t243 = t223.add_product(c.inverse_bobbin_mass, t232).add_product(t31, t230);
    let rod_omega_dot = (t29 * t234).sub_product(R::literal(4_166.666_666_666_667), t236)
        .sub_product(t30, t233);
    let rod_v_x_dot = (-t219).add_product(t27, t235).sub_product(R::literal(5.0), t234);
    let cylinder_omega_dot = (-t216.add_product(t24, t238)).add_product(t25, t237)
        .add_product(R::literal(2_777.777_777_777_778), t236).add_product(t26, t235);
    let cylinder_v_y_dot = t214.sub_product(R::literal(3.333_333_333_333_333_5), t237)
        .add_product(t23, t235);
    let cylinder_v_x_dot = t212.sub_product(R::literal(3.333_333_333_333_333_5), t238)
        .sub_product(t22, t235);
    let plate_omega_dot = (-c.t1.add_product(t18, t240)).add_product(t19, t239).sub_product(t18,
        t238).add_product(t19, t237).add_product(t20, t232).sub_product(t21, t231);
    let post_omega_dot = (t16 * t241).sub_product(t15, t242).sub_product(t15, t240)
        .add_product(t16, t239).sub_product(t17, t229);
    let t244 = (t1 * t241).add_product(t0, t242).add_product(t0, t240).add_product(t1, t239)
        .add_product(t205, t229);
    let t245 = t176.sub_product(t0, post_omega_dot).add_product(t15, t244);
    let t246 = (-t175.add_product(t1, post_omega_dot).add_product(t16, t244)).add_product(t39,
        t245);
    let t247 = t245.add_product(t41, t245).sub_product(t49, t246);
    let t248 = t246.sub_product(t51, t246).sub_product(t58, t247);
    let t249 = (t60 * t247).add_product(t72, t248);
    let t250 = (t61 * t247).add_product(t74, t248).add_product(t85, t249);
    let t251 = (-(t86 * t249)).add_product(t97, t250);
    let t252 = (-(t88 * t249)).add_product(t99, t250).sub_product(t108, t251);
    let t253 = (t109 * t251).add_product(t119, t252);
    let t254 = (t110 * t251).sub_product(t121, t252).sub_product(t130, t253);
    let t255 = (-(t64 * t247)).add_product(t77, t248).sub_product(t90, t249).add_product(t101, t250)
        .sub_product(t112, t251).sub_product(t123, t252).add_product(t132, t253).sub_product(t139,
        t254);
    let t256 = (t66 * t247).sub_product(t80, t248).sub_product(t92, t249).add_product(t103, t250)
        .sub_product(t114, t251).sub_product(t125, t252).add_product(t134, t253).sub_product(t141,
        t254).sub_product(t146, t255);
    let t257 = (t147 * t255).sub_product(t152, t256);
    let t258 = (t11 * post_omega_squared).sub_product(t205, post_omega_dot).add_product(t17, t244)
        .sub_product(t43, t245).sub_product(t53, t246).add_product(t68, t247).sub_product(t82, t248)
        .sub_product(t94, t249).add_product(t105, t250).sub_product(t116, t251).sub_product(t127,
        t252).add_product(t136, t253).sub_product(t143, t254).sub_product(t149, t255)
        .sub_product(t154, t256).sub_product(t159, t257) * t160;
    let t259 = (t257 * t157).sub_product(t159, t258);
    let t260 = (t256 * t150).sub_product(t152, t259).sub_product(t154, t258);
    let t261 = (t255 * t144).sub_product(t146, t260).add_product(t147, t259).sub_product(t149,
        t258);
    let t262 = (t254 * t137).sub_product(t139, t261).sub_product(t141, t260).sub_product(t143,
        t258);
    let t263 = (t253 * t128).add_product(t130, t262).sub_product(t132, t261).sub_product(t134, t260)
        .sub_product(t136, t258);
    let t264 = (t252 * t117).sub_product(t119, t263).sub_product(t121, t262).sub_product(t123, t261)
        .sub_product(t125, t260).sub_product(t127, t258);
    let t265 = (t251 * t106).sub_product(t108, t264).sub_product(t109, t263).add_product(t110, t262)
        .sub_product(t112, t261).sub_product(t114, t260).sub_product(t116, t258);
    let t266 = (t250 * t95).add_product(t97, t265).add_product(t99, t264).add_product(t101, t261)
        .add_product(t103, t260).add_product(t105, t258);
    let t267 = (t249 * t83).sub_product(t85, t266).add_product(t86, t265).add_product(t88, t264)
        .add_product(t90, t261).add_product(t92, t260).add_product(t94, t258);
    let t268 = (t248 * t70).sub_product(t72, t267).add_product(t74, t266).add_product(t77, t261)
        .sub_product(t80, t260).sub_product(t82, t258);
    let t269 = (t247 * t55).sub_product(t58, t268).sub_product(t60, t267).add_product(t61, t266)
        .sub_product(t64, t261).add_product(t66, t260).add_product(t68, t258);
    let t270 = (t246 * t47).sub_product(t49, t269).sub_product(t51, t268).sub_product(t53, t258);
    let t271 = (-(t245 * t37)).add_product(t39, t270).add_product(t41, t269).add_product(t39, t268)
        .sub_product(t43, t258);
    let drum_v_y_dot_by_post_phi = (t34 * t259).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t259);
    let drum_v_x_dot_by_post_phi = (t33 * t259).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t259);
    let bobbin_v_y_dot_by_post_phi = -(t32 * t259).add_product(c.inverse_bobbin_mass, t260);
    let bobbin_v_x_dot_by_post_phi = -(t31 * t259).add_product(c.inverse_bobbin_mass, t261);
    let rod_omega_dot_by_post_phi = (t29 * t263).sub_product(R::literal(4_166.666_666_666_667),
        t265).sub_product(t30, t262);
    let rod_v_y_dot_by_post_phi = -(R::literal(5.0) * t262).add_product(t28, t264);
    let rod_v_x_dot_by_post_phi = (R::literal(-5.0) * t263).add_product(t27, t264);
    let cylinder_omega_dot_by_post_phi = (-(t25 * t266).add_product(t24, t267))
        .add_product(R::literal(2_777.777_777_777_778), t265).add_product(t26, t264);
    let cylinder_v_y_dot_by_post_phi = (t23 * t264)
        .add_product(R::literal(3.333_333_333_333_333_5), t266);
    let cylinder_v_x_dot_by_post_phi = -(t22 * t264)
        .add_product(R::literal(3.333_333_333_333_333_5), t267);
    let plate_omega_dot_by_post_phi = (t19 * t268).sub_product(t18, t269).sub_product(t18, t267)
        .sub_product(t19, t266).add_product(t20, t261).sub_product(t21, t260);
    let plate_v_y_dot_by_post_phi = (-(R::literal(0.833_333_333_333_333_4) * t266)
        .add_product(R::literal(0.833_333_333_333_333_4), t268))
        .add_product(R::literal(0.833_333_333_333_333_4), t260);
    let plate_v_x_dot_by_post_phi = (R::literal(0.833_333_333_333_333_4) * t267)
        .sub_product(R::literal(0.833_333_333_333_333_4), t269)
        .add_product(R::literal(0.833_333_333_333_333_4), t261);
    let post_omega_dot_by_post_phi = (-(t244 * R::literal(370.370_370_370_370_3)).add_product(t15,
        t271)).add_product(t16, t270).sub_product(t15, t269).add_product(t16, t268)
        .sub_product(t17, t258);
    let post_v_y_dot_by_post_phi = (R::literal(1.25) * t268).sub_product(R::literal(1.25), t270);
    let post_v_x_dot_by_post_phi = (R::literal(1.25) * t269).sub_product(R::literal(1.25), t271);
    let t272 = R::literal(0.01) * cos_plate_phi.sub_product(R::literal(10.0), sin_plate_phi);
    let t273 = (-(t3 * t239).add_product(t2, t240).add_product(t2, t238).add_product(t3, t237))
        .add_product(t272, t232).add_product(t13, t231);
    let t274 = t179.sub_product(t2, plate_omega_dot).sub_product(t18, t273);
    let t275 = (-t178.add_product(t3, plate_omega_dot)).add_product(t19, t273);
    let t276 = t275.sub_product(t58, t274);
    let t277 = t274.sub_product(t60, t274).sub_product(t72, t276);
    let t278 = t275.sub_product(t61, t274).sub_product(t74, t276).add_product(t85, t277);
    let t279 = (t86 * t277).sub_product(t97, t278);
    let t280 = (t88 * t277).sub_product(t99, t278).sub_product(t108, t279);
    let t281 = (t109 * t279).add_product(t119, t280);
    let t282 = (t110 * t279).sub_product(t121, t280).sub_product(t130, t281);
    let t283 = (-(t13 * plate_omega_squared)).add_product(t272, plate_omega_dot).add_product(t20,
        t273).sub_product(t64, t274).add_product(t77, t276).add_product(t90, t277)
        .sub_product(t101, t278).sub_product(t112, t279).sub_product(t123, t280).add_product(t132,
        t281).sub_product(t139, t282);
    let t284 = t193.add_product(t13, plate_omega_dot).sub_product(t21, t273).add_product(t66, t274)
        .sub_product(t80, t276).add_product(t92, t277).sub_product(t103, t278).sub_product(t114,
        t279).sub_product(t125, t280).add_product(t134, t281).sub_product(t141, t282)
        .sub_product(t146, t283);
    let t285 = (t147 * t283).sub_product(t152, t284);
    let t286 = (t68 * t274).sub_product(t82, t276).add_product(t94, t277).sub_product(t105, t278)
        .sub_product(t116, t279).sub_product(t127, t280).add_product(t136, t281).sub_product(t143,
        t282).sub_product(t149, t283).sub_product(t154, t284).sub_product(t159, t285) * t160;
    let t287 = (t285 * t157).sub_product(t159, t286);
    let t288 = (t284 * t150).sub_product(t152, t287).sub_product(t154, t286);
    let t289 = (t283 * t144).sub_product(t146, t288).add_product(t147, t287).sub_product(t149,
        t286);
    let t290 = (t282 * t137).sub_product(t139, t289).sub_product(t141, t288).sub_product(t143,
        t286);
    let t291 = (t281 * t128).add_product(t130, t290).sub_product(t132, t289).sub_product(t134, t288)
        .sub_product(t136, t286);
    let t292 = (t280 * t117).sub_product(t119, t291).sub_product(t121, t290).sub_product(t123, t289)
        .sub_product(t125, t288).sub_product(t127, t286);
    let t293 = (t279 * t106).sub_product(t108, t292).sub_product(t109, t291).add_product(t110, t290)
        .sub_product(t112, t289).sub_product(t114, t288).sub_product(t116, t286);
    let t294 = (t278 * t95).sub_product(t97, t293).sub_product(t99, t292).sub_product(t101, t289)
        .sub_product(t103, t288).sub_product(t105, t286);
    let t295 = (-(t277 * t83)).add_product(t85, t294).add_product(t86, t293).add_product(t88, t292)
        .add_product(t90, t289).add_product(t92, t288).add_product(t94, t286);
    let t296 = (t276 * t70).sub_product(t72, t295).sub_product(t74, t294).add_product(t77, t289)
        .sub_product(t80, t288).sub_product(t82, t286);
    let t297 = (t274 * t55).sub_product(t58, t296).sub_product(t60, t295).sub_product(t61, t294)
        .sub_product(t64, t289).add_product(t66, t288).add_product(t68, t286);
    let t298 = (t51 * t296).add_product(t49, t297).add_product(t53, t286);
    let t299 = (t41 * t297).sub_product(t39, t298).add_product(t39, t296).sub_product(t43, t286);
    let drum_v_y_dot_by_plate_phi = (t34 * t287).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t287);
    let drum_v_x_dot_by_plate_phi = (t33 * t287).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t287);
    let bobbin_v_y_dot_by_plate_phi = -(t32 * t287).add_product(c.inverse_bobbin_mass, t288);
    let bobbin_v_x_dot_by_plate_phi = -(t31 * t287).add_product(c.inverse_bobbin_mass, t289);
    let rod_omega_dot_by_plate_phi = (t29 * t291).sub_product(R::literal(4_166.666_666_666_667),
        t293).sub_product(t30, t290);
    let rod_v_y_dot_by_plate_phi = -(R::literal(5.0) * t290).add_product(t28, t292);
    let rod_v_x_dot_by_plate_phi = (R::literal(-5.0) * t291).add_product(t27, t292);
    let cylinder_omega_dot_by_plate_phi = (t25 * t294).sub_product(t24, t295)
        .add_product(R::literal(2_777.777_777_777_778), t293).add_product(t26, t292);
    let cylinder_v_y_dot_by_plate_phi = (t23 * t292)
        .sub_product(R::literal(3.333_333_333_333_333_5), t294);
    let cylinder_v_x_dot_by_plate_phi = -(t22 * t292)
        .add_product(R::literal(3.333_333_333_333_333_5), t295);
    let plate_omega_dot_by_plate_phi = (t273 * R::literal(400.0)).sub_product(t18, t297)
        .add_product(t19, t296).sub_product(t18, t295).add_product(t19, t294).add_product(t20, t289)
        .sub_product(t21, t288);
    let plate_v_y_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t294)
        .sub_product(R::literal(0.833_333_333_333_333_4), t296)
        .add_product(R::literal(0.833_333_333_333_333_4), t288);
    let plate_v_x_dot_by_plate_phi = (R::literal(0.833_333_333_333_333_4) * t295)
        .sub_product(R::literal(0.833_333_333_333_333_4), t297)
        .add_product(R::literal(0.833_333_333_333_333_4), t289);
    let post_omega_dot_by_plate_phi = (-(t16 * t298).add_product(t15, t299).add_product(t15, t297))
        .add_product(t16, t296).sub_product(t17, t286);
    let post_v_y_dot_by_plate_phi = (R::literal(1.25) * t296).add_product(R::literal(1.25), t298);
    let post_v_x_dot_by_plate_phi = (R::literal(1.25) * t297).sub_product(R::literal(1.25), t299);
    let t300 = p.spring_stiffness * cos_cylinder_phi;
    let t301 = R::literal(50.0) * cylinder_omega;
    let t302 = t301 * sin_cylinder_phi;
    let t303 = t302 - t300;
    let t304 = t303 * cos_cylinder_phi;
    let t305 = t303 * sin_cylinder_phi;
    let t306 = t301 * t10;
    let t307 = t306 * sin_cylinder_phi;
    let t308 = p.spring_stiffness * t10;
    let t309 = t308 * cos_cylinder_phi;
    let t310 = t300 - t302;
    let t311 = t310 * cos_cylinder_phi;
    let t312 = t310 * sin_cylinder_phi;
    let t313 = cos_cylinder_phi * t235;
    let t314 = t309 - t307 - t167 - t166 - t313;
    let t315 = cos_cylinder_phi * cylinder_omega_dot;
    let t316 = R::literal(3.333_333_333_333_333_5) * t304;
    let t317 = t316.add_product(t24, t314);
    let t318 = R::literal(3.333_333_333_333_333_5) * t305;
    let t319 = (-t318).add_product(t25, t314).sub_product(t85, t317);
    let t320 = R::literal(2_777.777_777_777_778) * t314;
    let t321 = t320.sub_product(t86, t317).sub_product(t97, t319);
    let t322 = (t181 - t315).sub_product(t22, t304).add_product(t23, t305).add_product(t26, t314)
        .add_product(t27, t311).sub_product(t28, t312).sub_product(t88, t317).sub_product(t99, t319)
        .sub_product(t108, t321);
    let t323 = R::literal(5.0) * t311;
    let t324 = t323.add_product(t109, t321).add_product(t119, t322);
    let t325 = R::literal(5.0) * t312;
    let t326 = (-t325).add_product(t110, t321).sub_product(t121, t322).sub_product(t130, t324);
    let t327 = (-(t90 * t317).add_product(t101, t319).add_product(t112, t321).add_product(t123,
        t322)).add_product(t132, t324).sub_product(t139, t326);
    let t328 = (-(t92 * t317).add_product(t103, t319).add_product(t114, t321).add_product(t125,
        t322)).add_product(t134, t324).sub_product(t141, t326).sub_product(t146, t327);
    let t329 = (t147 * t327).sub_product(t152, t328);
    let t330 = (-(t94 * t317).add_product(t105, t319).add_product(t116, t321).add_product(t127,
        t322)).add_product(t136, t324).sub_product(t143, t326).sub_product(t149, t327)
        .sub_product(t154, t328).sub_product(t159, t329) * t160;
    let t331 = (t329 * t157).sub_product(t159, t330);
    let t332 = (t328 * t150).sub_product(t152, t331).sub_product(t154, t330);
    let t333 = (t327 * t144).sub_product(t146, t332).add_product(t147, t331).sub_product(t149,
        t330);
    let t334 = (t326 * t137).sub_product(t139, t333).sub_product(t141, t332).sub_product(t143,
        t330);
    let t335 = (t324 * t128).add_product(t130, t334).sub_product(t132, t333).sub_product(t134, t332)
        .sub_product(t136, t330);
    let t336 = (t322 * t117).sub_product(t119, t335).sub_product(t121, t334).sub_product(t123, t333)
        .sub_product(t125, t332).sub_product(t127, t330);
    let t337 = (t321 * t106).sub_product(t108, t336).sub_product(t109, t335).add_product(t110, t334)
        .sub_product(t112, t333).sub_product(t114, t332).sub_product(t116, t330);
    let t338 = (t319 * t95).sub_product(t97, t337).sub_product(t99, t336).sub_product(t101, t333)
        .sub_product(t103, t332).sub_product(t105, t330);
    let t339 = (t317 * t83).add_product(t85, t338).add_product(t86, t337).add_product(t88, t336)
        .add_product(t90, t333).add_product(t92, t332).add_product(t94, t330);
    let t340 = (-(t74 * t338).add_product(t72, t339)).add_product(t77, t333).sub_product(t80, t332)
        .sub_product(t82, t330);
    let t341 = (-(t60 * t339).add_product(t58, t340).add_product(t61, t338).add_product(t64, t333))
        .add_product(t66, t332).add_product(t68, t330);
    let t342 = (t51 * t340).add_product(t49, t341).add_product(t53, t330);
    let t343 = (t41 * t341).sub_product(t39, t342).add_product(t39, t340).sub_product(t43, t330);
    let drum_v_y_dot_by_cylinder_x = (t34 * t331).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t331);
    let drum_v_x_dot_by_cylinder_x = (t33 * t331).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t331);
    let bobbin_v_y_dot_by_cylinder_x = -(t32 * t331).add_product(c.inverse_bobbin_mass, t332);
    let bobbin_v_x_dot_by_cylinder_x = -(t31 * t331).add_product(c.inverse_bobbin_mass, t333);
    let rod_omega_dot_by_cylinder_x = (t29 * t335).sub_product(R::literal(4_166.666_666_666_667),
        t337).sub_product(t30, t334);
    let rod_v_y_dot_by_cylinder_x = t325.sub_product(t28, t336).sub_product(R::literal(5.0), t334);
    let rod_v_x_dot_by_cylinder_x = t323.add_product(t27, t336).sub_product(R::literal(5.0), t335);
    let cylinder_omega_dot_by_cylinder_x = t320.sub_product(t24, t339).add_product(t25, t338)
        .add_product(R::literal(2_777.777_777_777_778), t337).add_product(t26, t336);
    let cylinder_v_y_dot_by_cylinder_x = t318.sub_product(R::literal(3.333_333_333_333_333_5), t338)
        .add_product(t23, t336);
    let cylinder_v_x_dot_by_cylinder_x = t316.sub_product(R::literal(3.333_333_333_333_333_5), t339)
        .sub_product(t22, t336);
    let plate_omega_dot_by_cylinder_x = (t19 * t340).sub_product(t18, t341).sub_product(t18, t339)
        .add_product(t19, t338).add_product(t20, t333).sub_product(t21, t332);
    let plate_v_y_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t338)
        .sub_product(R::literal(0.833_333_333_333_333_4), t340)
        .add_product(R::literal(0.833_333_333_333_333_4), t332);
    let plate_v_x_dot_by_cylinder_x = (R::literal(0.833_333_333_333_333_4) * t339)
        .sub_product(R::literal(0.833_333_333_333_333_4), t341)
        .add_product(R::literal(0.833_333_333_333_333_4), t333);
    let post_omega_dot_by_cylinder_x = (-(t16 * t342).add_product(t15, t343).add_product(t15, t341))
        .add_product(t16, t340).sub_product(t17, t330);
    let post_v_y_dot_by_cylinder_x = (R::literal(1.25) * t340).add_product(R::literal(1.25), t342);
    let post_v_x_dot_by_cylinder_x = (R::literal(1.25) * t341).sub_product(R::literal(1.25), t343);
    let t344 = (t301 * cos_cylinder_phi).add_product(p.spring_stiffness, sin_cylinder_phi);
    let t345 = t344 * cos_cylinder_phi;
    let t346 = t344 * sin_cylinder_phi;
    let t347 = t308 * sin_cylinder_phi;
    let t348 = t162.add_product(t306, cos_cylinder_phi) + t164 + t347;
    let t349 = sin_cylinder_phi * t235;
    let t350 = t348 - t349;
    let t351 = t180.add_product(sin_cylinder_phi, cylinder_omega_dot);
    let t352 = R::literal(3.333_333_333_333_333_5) * t345;
    let t353 = t352.sub_product(t24, t350);
    let t354 = R::literal(3.333_333_333_333_333_5) * t346;
    let t355 = t354.add_product(t25, t350).add_product(t85, t353);
    let t356 = R::literal(2_777.777_777_777_778) * t350;
    let t357 = t356.add_product(t86, t353).sub_product(t97, t355);
    let t358 = t22 * t345;
    let t359 = t23 * t346;
    let t360 = t27 * t345;
    let t361 = t28 * t346;
    let t362 = ((t358 - t351 - t359).add_product(t26, t350) + t360 - t361).add_product(t88, t353)
        .sub_product(t99, t355).sub_product(t108, t357);
    let t363 = R::literal(5.0) * t345;
    let t364 = t363.add_product(t109, t357).add_product(t119, t362);
    let t365 = R::literal(5.0) * t346;
    let t366 = (-t365).add_product(t110, t357).sub_product(t121, t362).sub_product(t130, t364);
    let t367 = (t90 * t353).sub_product(t101, t355).sub_product(t112, t357).sub_product(t123, t362)
        .add_product(t132, t364).sub_product(t139, t366);
    let t368 = (t92 * t353).sub_product(t103, t355).sub_product(t114, t357).sub_product(t125, t362)
        .add_product(t134, t364).sub_product(t141, t366).sub_product(t146, t367);
    let t369 = (t147 * t367).sub_product(t152, t368);
    let t370 = (t94 * t353).sub_product(t105, t355).sub_product(t116, t357).sub_product(t127, t362)
        .add_product(t136, t364).sub_product(t143, t366).sub_product(t149, t367).sub_product(t154,
        t368).sub_product(t159, t369) * t160;
    let t371 = (t369 * t157).sub_product(t159, t370);
    let t372 = (t368 * t150).sub_product(t152, t371).sub_product(t154, t370);
    let t373 = (t367 * t144).sub_product(t146, t372).add_product(t147, t371).sub_product(t149,
        t370);
    let t374 = (t366 * t137).sub_product(t139, t373).sub_product(t141, t372).sub_product(t143,
        t370);
    let t375 = (t364 * t128).add_product(t130, t374).sub_product(t132, t373).sub_product(t134, t372)
        .sub_product(t136, t370);
    let t376 = (t362 * t117).sub_product(t119, t375).sub_product(t121, t374).sub_product(t123, t373)
        .sub_product(t125, t372).sub_product(t127, t370);
    let t377 = (t357 * t106).sub_product(t108, t376).sub_product(t109, t375).add_product(t110, t374)
        .sub_product(t112, t373).sub_product(t114, t372).sub_product(t116, t370);
    let t378 = (t355 * t95).sub_product(t97, t377).sub_product(t99, t376).sub_product(t101, t373)
        .sub_product(t103, t372).sub_product(t105, t370);
    let t379 = (-(t353 * t83)).add_product(t85, t378).add_product(t86, t377).add_product(t88, t376)
        .add_product(t90, t373).add_product(t92, t372).add_product(t94, t370);
    let t380 = (-(t74 * t378).add_product(t72, t379)).add_product(t77, t373).sub_product(t80, t372)
        .sub_product(t82, t370);
    let t381 = (-(t60 * t379).add_product(t58, t380).add_product(t61, t378).add_product(t64, t373))
        .add_product(t66, t372).add_product(t68, t370);
    let t382 = (t51 * t380).add_product(t49, t381).add_product(t53, t370);
    let t383 = (t41 * t381).sub_product(t39, t382).add_product(t39, t380).sub_product(t43, t370);
    let drum_v_y_dot_by_cylinder_y = (t34 * t371).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t371);
    let drum_v_x_dot_by_cylinder_y = (t33 * t371).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t371);
    let bobbin_v_y_dot_by_cylinder_y = -(t32 * t371).add_product(c.inverse_bobbin_mass, t372);
    let bobbin_v_x_dot_by_cylinder_y = -(t31 * t371).add_product(c.inverse_bobbin_mass, t373);
    let rod_omega_dot_by_cylinder_y = (t29 * t375).sub_product(R::literal(4_166.666_666_666_667),
        t377).sub_product(t30, t374);
    let rod_v_y_dot_by_cylinder_y = t365.sub_product(t28, t376).sub_product(R::literal(5.0), t374);
    let rod_v_x_dot_by_cylinder_y = t363.add_product(t27, t376).sub_product(R::literal(5.0), t375);
    let cylinder_omega_dot_by_cylinder_y = t356.sub_product(t24, t379).add_product(t25, t378)
        .add_product(R::literal(2_777.777_777_777_778), t377).add_product(t26, t376);
    let cylinder_v_y_dot_by_cylinder_y = (-t354.add_product(R::literal(3.333_333_333_333_333_5),
        t378)).add_product(t23, t376);
    let cylinder_v_x_dot_by_cylinder_y = -t352.add_product(R::literal(3.333_333_333_333_333_5),
        t379).add_product(t22, t376);
    let plate_omega_dot_by_cylinder_y = (t19 * t380).sub_product(t18, t381).sub_product(t18, t379)
        .add_product(t19, t378).add_product(t20, t373).sub_product(t21, t372);
    let plate_v_y_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t378)
        .sub_product(R::literal(0.833_333_333_333_333_4), t380)
        .add_product(R::literal(0.833_333_333_333_333_4), t372);
    let plate_v_x_dot_by_cylinder_y = (R::literal(0.833_333_333_333_333_4) * t379)
        .sub_product(R::literal(0.833_333_333_333_333_4), t381)
        .add_product(R::literal(0.833_333_333_333_333_4), t373);
    let post_omega_dot_by_cylinder_y = (-(t16 * t382).add_product(t15, t383).add_product(t15, t381))
        .add_product(t16, t380).sub_product(t17, t370);
    let post_v_y_dot_by_cylinder_y = (R::literal(1.25) * t380).add_product(R::literal(1.25), t382);
    let post_v_x_dot_by_cylinder_y = (R::literal(1.25) * t381).sub_product(R::literal(1.25), t383);
    let t384 = R::literal(50.0) * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
        .sub_product(cylinder_omega, slide).sub_product(rod_v_x_minus_cylinder_v_x,
        sin_cylinder_phi);
    let t385 = t384 * cos_cylinder_phi;
    let t386 = t162.add_product(t384, sin_cylinder_phi) + (t164 + t347);
    let t387 = t10 * t10;
    let t388 = R::literal(0.06) * cylinder_omega_squared;
    let t389 = t385 + t309 - t167 - t166 - t313;
    let t390 = t386 - t349;
    let t391 = t8 - t9;
    let t392 = (p.spring_stiffness * slide * slide_minus_spring_free_length)
        .add_product(R::literal(50.0) * slide, slide_rate).sub_product(t384, t10)
        .sub_product(p.spring_stiffness, t387).sub_product(t4, t238).sub_product(t5, t237)
        .sub_product(t391, t235);
    let t393 = t167 + t166 - t385 - t309 + t313;
    let t394 = t349 - t386;
    let t395 = R::literal(3.333_333_333_333_333_5) * t389;
    let t396 = ((t388 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t395)
        .sub_product(t24, t392);
    let t397 = R::literal(3.333_333_333_333_333_5) * t390;
    let t398 = (-((t388 * cos_cylinder_phi).add_product(t5, cylinder_omega_dot) + t397))
        .add_product(t25, t392).add_product(t85, t396);
    let t399 = R::literal(2_777.777_777_777_778) * t392;
    let t400 = t399.add_product(t86, t396).sub_product(t97, t398);
    let t401 = (cylinder_omega * (t182 * sin_cylinder_phi).add_product(t187, cos_cylinder_phi)
        .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
        .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi).sub_product(t183,
        cos_cylinder_phi).sub_product(t186, sin_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi)).sub_product(cos_cylinder_phi,
        cylinder_v_x_dot).sub_product(sin_cylinder_phi, cylinder_v_y_dot).sub_product(t391,
        cylinder_omega_dot).add_product(cos_cylinder_phi, rod_v_x_dot)
        .sub_product(sin_cylinder_phi, t221.add_product(t28, t235).add_product(R::literal(5.0),
        t233)).sub_product(t22, t389).add_product(t23, t390).add_product(t26, t392)
        .add_product(t27, t393).sub_product(t28, t394).add_product(t88, t396).sub_product(t99, t398)
        .sub_product(t108, t400);
    let t402 = R::literal(5.0) * t393;
    let t403 = t402.add_product(t109, t400).add_product(t119, t401);
    let t404 = R::literal(5.0) * t394;
    let t405 = (-t404).add_product(t110, t400).sub_product(t121, t401).sub_product(t130, t403);
    let t406 = (t90 * t396).sub_product(t101, t398).sub_product(t112, t400).sub_product(t123, t401)
        .add_product(t132, t403).sub_product(t139, t405);
    let t407 = (t92 * t396).sub_product(t103, t398).sub_product(t114, t400).sub_product(t125, t401)
        .add_product(t134, t403).sub_product(t141, t405).sub_product(t146, t406);
    let t408 = (t147 * t406).sub_product(t152, t407);
    let t409 = (t94 * t396).sub_product(t105, t398).sub_product(t116, t400).sub_product(t127, t401)
        .add_product(t136, t403).sub_product(t143, t405).sub_product(t149, t406).sub_product(t154,
        t407).sub_product(t159, t408) * t160;
    let t410 = (t408 * t157).sub_product(t159, t409);
    let t411 = (t407 * t150).sub_product(t152, t410).sub_product(t154, t409);
    let t412 = (t406 * t144).sub_product(t146, t411).add_product(t147, t410).sub_product(t149,
        t409);
    let t413 = (t405 * t137).sub_product(t139, t412).sub_product(t141, t411).sub_product(t143,
        t409);
    let t414 = (t403 * t128).add_product(t130, t413).sub_product(t132, t412).sub_product(t134, t411)
        .sub_product(t136, t409);
    let t415 = (t401 * t117).sub_product(t119, t414).sub_product(t121, t413).sub_product(t123, t412)
        .sub_product(t125, t411).sub_product(t127, t409);
    let t416 = (t400 * t106).sub_product(t108, t415).sub_product(t109, t414).add_product(t110, t413)
        .sub_product(t112, t412).sub_product(t114, t411).sub_product(t116, t409);
    let t417 = (t398 * t95).sub_product(t97, t416).sub_product(t99, t415).sub_product(t101, t412)
        .sub_product(t103, t411).sub_product(t105, t409);
    let t418 = (-(t396 * t83)).add_product(t85, t417).add_product(t86, t416).add_product(t88, t415)
        .add_product(t90, t412).add_product(t92, t411).add_product(t94, t409);
    let t419 = (-(t74 * t417).add_product(t72, t418)).add_product(t77, t412).sub_product(t80, t411)
        .sub_product(t82, t409);
    let t420 = (-(t60 * t418).add_product(t58, t419).add_product(t61, t417).add_product(t64, t412))
        .add_product(t66, t411).add_product(t68, t409);
    let t421 = (t51 * t419).add_product(t49, t420).add_product(t53, t409);
    let t422 = (t41 * t420).sub_product(t39, t421).add_product(t39, t419).sub_product(t43, t409);
    let drum_v_y_dot_by_cylinder_phi = (t34 * t410)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t410);
    let drum_v_x_dot_by_cylinder_phi = (t33 * t410)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t410);
    let bobbin_v_y_dot_by_cylinder_phi = -(t32 * t410).add_product(c.inverse_bobbin_mass, t411);
    let bobbin_v_x_dot_by_cylinder_phi = -(t31 * t410).add_product(c.inverse_bobbin_mass, t412);
    let rod_omega_dot_by_cylinder_phi = (t29 * t414).sub_product(R::literal(4_166.666_666_666_667),
        t416).sub_product(t30, t413);
    let rod_v_y_dot_by_cylinder_phi = t404.sub_product(t28, t415).sub_product(R::literal(5.0),
        t413);
    let rod_v_x_dot_by_cylinder_phi = t402.add_product(t27, t415).sub_product(R::literal(5.0),
        t414);
    let cylinder_omega_dot_by_cylinder_phi = t399.sub_product(t24, t418).add_product(t25, t417)
        .add_product(R::literal(2_777.777_777_777_778), t416).add_product(t26, t415);
    let cylinder_v_y_dot_by_cylinder_phi = t397.sub_product(R::literal(3.333_333_333_333_333_5),
        t417).add_product(t23, t415);
    let cylinder_v_x_dot_by_cylinder_phi = t395.sub_product(R::literal(3.333_333_333_333_333_5),
        t418).sub_product(t22, t415);
    let plate_omega_dot_by_cylinder_phi = (t19 * t419).sub_product(t18, t420).sub_product(t18, t418)
        .add_product(t19, t417).add_product(t20, t412).sub_product(t21, t411);
    let plate_v_y_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t417)
        .sub_product(R::literal(0.833_333_333_333_333_4), t419)
        .add_product(R::literal(0.833_333_333_333_333_4), t411);
    let plate_v_x_dot_by_cylinder_phi = (R::literal(0.833_333_333_333_333_4) * t418)
        .sub_product(R::literal(0.833_333_333_333_333_4), t420)
        .add_product(R::literal(0.833_333_333_333_333_4), t412);
    let post_omega_dot_by_cylinder_phi = (-(t16 * t421).add_product(t15, t422).add_product(t15,
        t420)).add_product(t16, t419).sub_product(t17, t409);
    let post_v_y_dot_by_cylinder_phi = (R::literal(1.25) * t419).add_product(R::literal(1.25),
        t421);
    let post_v_x_dot_by_cylinder_phi = (R::literal(1.25) * t420).sub_product(R::literal(1.25),
        t422);
    let t423 = t307 + t167 + t166 - t309 + t313;
    let t424 = R::literal(3.333_333_333_333_333_5) * t311;
    let t425 = t424.add_product(t24, t423);
    let t426 = R::literal(3.333_333_333_333_333_5) * t312;
    let t427 = (-t426).add_product(t25, t423).sub_product(t85, t425);
    let t428 = R::literal(2_777.777_777_777_778) * t423;
    let t429 = t428.sub_product(t86, t425).sub_product(t97, t427);
    let t430 = (t315 - t181).sub_product(t22, t311).add_product(t23, t312).add_product(t26, t423)
        .add_product(t27, t304).sub_product(t28, t305).sub_product(t88, t425).sub_product(t99, t427)
        .sub_product(t108, t429);
    let t431 = R::literal(5.0) * t304;
    let t432 = t431.add_product(t109, t429).add_product(t119, t430);
    let t433 = R::literal(5.0) * t305;
    let t434 = (-t433).add_product(t110, t429).sub_product(t121, t430).sub_product(t130, t432);
    let t435 = (-(t90 * t425).add_product(t101, t427).add_product(t112, t429).add_product(t123,
        t430)).add_product(t132, t432).sub_product(t139, t434);
    let t436 = (-(t92 * t425).add_product(t103, t427).add_product(t114, t429).add_product(t125,
        t430)).add_product(t134, t432).sub_product(t141, t434).sub_product(t146, t435);
    let t437 = (t147 * t435).sub_product(t152, t436);
    let t438 = (-(t94 * t425).add_product(t105, t427).add_product(t116, t429).add_product(t127,
        t430)).add_product(t136, t432).sub_product(t143, t434).sub_product(t149, t435)
        .sub_product(t154, t436).sub_product(t159, t437) * t160;
    let t439 = (t437 * t157).sub_product(t159, t438);
    let t440 = (t436 * t150).sub_product(t152, t439).sub_product(t154, t438);
    let t441 = (t435 * t144).sub_product(t146, t440).add_product(t147, t439).sub_product(t149,
        t438);
    let t442 = (t434 * t137).sub_product(t139, t441).sub_product(t141, t440).sub_product(t143,
        t438);
    let t443 = (t432 * t128).add_product(t130, t442).sub_product(t132, t441).sub_product(t134, t440)
        .sub_product(t136, t438);
    let t444 = (t430 * t117).sub_product(t119, t443).sub_product(t121, t442).sub_product(t123, t441)
        .sub_product(t125, t440).sub_product(t127, t438);
    let t445 = (t429 * t106).sub_product(t108, t444).sub_product(t109, t443).add_product(t110, t442)
        .sub_product(t112, t441).sub_product(t114, t440).sub_product(t116, t438);
    let t446 = (t427 * t95).sub_product(t97, t445).sub_product(t99, t444).sub_product(t101, t441)
        .sub_product(t103, t440).sub_product(t105, t438);
    let t447 = (t425 * t83).add_product(t85, t446).add_product(t86, t445).add_product(t88, t444)
        .add_product(t90, t441).add_product(t92, t440).add_product(t94, t438);
    let t448 = (-(t74 * t446).add_product(t72, t447)).add_product(t77, t441).sub_product(t80, t440)
        .sub_product(t82, t438);
    let t449 = (-(t60 * t447).add_product(t58, t448).add_product(t61, t446).add_product(t64, t441))
        .add_product(t66, t440).add_product(t68, t438);
    let t450 = (t51 * t448).add_product(t49, t449).add_product(t53, t438);
    let t451 = (t41 * t449).sub_product(t39, t450).add_product(t39, t448).sub_product(t43, t438);
    let drum_v_y_dot_by_rod_x = (t34 * t439).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t439);
    let drum_v_x_dot_by_rod_x = (t33 * t439).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t439);
    let bobbin_v_y_dot_by_rod_x = -(t32 * t439).add_product(c.inverse_bobbin_mass, t440);
    let bobbin_v_x_dot_by_rod_x = -(t31 * t439).add_product(c.inverse_bobbin_mass, t441);
    let rod_omega_dot_by_rod_x = (t29 * t443).sub_product(R::literal(4_166.666_666_666_667), t445)
        .sub_product(t30, t442);
    let rod_v_y_dot_by_rod_x = t433.sub_product(t28, t444).sub_product(R::literal(5.0), t442);
    let rod_v_x_dot_by_rod_x = t431.add_product(t27, t444).sub_product(R::literal(5.0), t443);
    let cylinder_omega_dot_by_rod_x = t428.sub_product(t24, t447).add_product(t25, t446)
        .add_product(R::literal(2_777.777_777_777_778), t445).add_product(t26, t444);
    let cylinder_v_y_dot_by_rod_x = t426.sub_product(R::literal(3.333_333_333_333_333_5), t446)
        .add_product(t23, t444);
    let cylinder_v_x_dot_by_rod_x = t424.sub_product(R::literal(3.333_333_333_333_333_5), t447)
        .sub_product(t22, t444);
    let plate_omega_dot_by_rod_x = (t19 * t448).sub_product(t18, t449).sub_product(t18, t447)
        .add_product(t19, t446).add_product(t20, t441).sub_product(t21, t440);
    let plate_v_y_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t446)
        .sub_product(R::literal(0.833_333_333_333_333_4), t448)
        .add_product(R::literal(0.833_333_333_333_333_4), t440);
    let plate_v_x_dot_by_rod_x = (R::literal(0.833_333_333_333_333_4) * t447)
        .sub_product(R::literal(0.833_333_333_333_333_4), t449)
        .add_product(R::literal(0.833_333_333_333_333_4), t441);
    let post_omega_dot_by_rod_x = (-(t16 * t450).add_product(t15, t451).add_product(t15, t449))
        .add_product(t16, t448).sub_product(t17, t438);
    let post_v_y_dot_by_rod_x = (R::literal(1.25) * t448).add_product(R::literal(1.25), t450);
    let post_v_x_dot_by_rod_x = (R::literal(1.25) * t449).sub_product(R::literal(1.25), t451);
    let t452 = t349 - t348;
    let t453 = t352.add_product(t24, t452);
    let t454 = (-t354).add_product(t25, t452).sub_product(t85, t453);
    let t455 = R::literal(2_777.777_777_777_778) * t452;
    let t456 = t455.sub_product(t86, t453).sub_product(t97, t454);
    let t457 = ((t351 - t358 + t359).add_product(t26, t452) - t360 + t361).sub_product(t88, t453)
        .sub_product(t99, t454).sub_product(t108, t456);
    let t458 = t363.sub_product(t109, t456).sub_product(t119, t457);
    let t459 = t365.add_product(t110, t456).sub_product(t121, t457).add_product(t130, t458);
    let t460 = (t90 * t453).add_product(t101, t454).add_product(t112, t456).add_product(t123, t457)
        .add_product(t132, t458).add_product(t139, t459);
    let t461 = (-(t92 * t453).add_product(t103, t454).add_product(t114, t456).add_product(t125,
        t457).add_product(t134, t458).add_product(t141, t459)).add_product(t146, t460);
    let t462 = (t147 * t460).add_product(t152, t461);
    let t463 = (-(t94 * t453).add_product(t105, t454).add_product(t116, t456).add_product(t127,
        t457).add_product(t136, t458).add_product(t143, t459)).add_product(t149, t460)
        .sub_product(t154, t461).add_product(t159, t462) * t160;
    let t464 = (t462 * t157).add_product(t159, t463);
    let t465 = (t461 * t150).add_product(t152, t464).sub_product(t154, t463);
    let t466 = (t460 * t144).add_product(t146, t465).add_product(t147, t464).add_product(t149,
        t463);
    let t467 = (t459 * t137).add_product(t139, t466).sub_product(t141, t465).sub_product(t143,
        t463);
    let t468 = (-(t458 * t128)).add_product(t130, t467).add_product(t132, t466).sub_product(t134,
        t465).sub_product(t136, t463);
    let t469 = (t457 * t117).sub_product(t119, t468).sub_product(t121, t467).add_product(t123, t466)
        .sub_product(t125, t465).sub_product(t127, t463);
    let t470 = (t456 * t106).sub_product(t108, t469).sub_product(t109, t468).add_product(t110, t467)
        .add_product(t112, t466).sub_product(t114, t465).sub_product(t116, t463);
    let t471 = (t454 * t95).sub_product(t97, t470).sub_product(t99, t469).add_product(t101, t466)
        .sub_product(t103, t465).sub_product(t105, t463);
    let t472 = (t453 * t83).add_product(t85, t471).add_product(t86, t470).add_product(t88, t469)
        .sub_product(t90, t466).add_product(t92, t465).add_product(t94, t463);
    let t473 = (t74 * t471).add_product(t72, t472).add_product(t77, t466).add_product(t80, t465)
        .add_product(t82, t463);
    let t474 = (-(t60 * t472)).add_product(t58, t473).sub_product(t61, t471).add_product(t64, t466)
        .add_product(t66, t465).add_product(t68, t463);
    let t475 = (t51 * t473).sub_product(t49, t474).sub_product(t53, t463);
    let t476 = (t41 * t474).add_product(t39, t475).sub_product(t39, t473).sub_product(t43, t463);
    let drum_v_y_dot_by_rod_y = (-(t34 * t464)).add_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t464);
    let drum_v_x_dot_by_rod_y = (-(t33 * t464)).add_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t464);
    let bobbin_v_y_dot_by_rod_y = (t32 * t464).sub_product(c.inverse_bobbin_mass, t465);
    let bobbin_v_x_dot_by_rod_y = (t31 * t464).add_product(c.inverse_bobbin_mass, t466);
    let rod_omega_dot_by_rod_y = (t29 * t468).sub_product(R::literal(4_166.666_666_666_667), t470)
        .sub_product(t30, t467);
    let rod_v_y_dot_by_rod_y = -t365.add_product(t28, t469).add_product(R::literal(5.0), t467);
    let rod_v_x_dot_by_rod_y = (-t363).add_product(t27, t469).sub_product(R::literal(5.0), t468);
    let cylinder_omega_dot_by_rod_y = t455.sub_product(t24, t472).add_product(t25, t471)
        .add_product(R::literal(2_777.777_777_777_778), t470).add_product(t26, t469);
    let cylinder_v_y_dot_by_rod_y = t354.sub_product(R::literal(3.333_333_333_333_333_5), t471)
        .add_product(t23, t469);
    let cylinder_v_x_dot_by_rod_y = t352.sub_product(R::literal(3.333_333_333_333_333_5), t472)
        .sub_product(t22, t469);
    let plate_omega_dot_by_rod_y = (-(t19 * t473).add_product(t18, t474).add_product(t18, t472))
        .add_product(t19, t471).sub_product(t20, t466).sub_product(t21, t465);
    let plate_v_y_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t471)
        .add_product(R::literal(0.833_333_333_333_333_4), t473)
        .add_product(R::literal(0.833_333_333_333_333_4), t465);
    let plate_v_x_dot_by_rod_y = (R::literal(0.833_333_333_333_333_4) * t472)
        .sub_product(R::literal(0.833_333_333_333_333_4), t474)
        .sub_product(R::literal(0.833_333_333_333_333_4), t466);
    let post_omega_dot_by_rod_y = (t16 * t475).sub_product(t15, t476).sub_product(t15, t474)
        .sub_product(t16, t473).sub_product(t17, t463);
    let post_v_y_dot_by_rod_y = -(R::literal(1.25) * t473).add_product(R::literal(1.25), t475);
    let post_v_x_dot_by_rod_y = (R::literal(1.25) * t474).sub_product(R::literal(1.25), t476);
    let t477 = (t7 * t233).add_product(t6, t234);
    let t478 = R::literal(4_166.666_666_666_667) * t477;
    let t479 = t108 * t478;
    let t480 = (-t192).add_product(t6, rod_omega_dot).add_product(t29, t477).add_product(t109, t478)
        .sub_product(t119, t479);
    let t481 = t191.add_product(t7, rod_omega_dot).sub_product(t30, t477).sub_product(t110, t478)
        .sub_product(t121, t479).add_product(t130, t480);
    let t482 = (t112 * t478).sub_product(t123, t479).sub_product(t132, t480).sub_product(t139,
        t481);
    let t483 = (t114 * t478).sub_product(t125, t479).sub_product(t134, t480).sub_product(t141, t481)
        .sub_product(t146, t482);
    let t484 = (t147 * t482).sub_product(t152, t483);
    let t485 = (t116 * t478).sub_product(t127, t479).sub_product(t136, t480).sub_product(t143, t481)
        .sub_product(t149, t482).sub_product(t154, t483).sub_product(t159, t484) * t160;
    let t486 = (t484 * t157).sub_product(t159, t485);
    let t487 = (t483 * t150).sub_product(t152, t486).sub_product(t154, t485);
    let t488 = (t482 * t144).sub_product(t146, t487).add_product(t147, t486).sub_product(t149,
        t485);
    let t489 = (t481 * t137).sub_product(t139, t488).sub_product(t141, t487).sub_product(t143,
        t485);
    let t490 = (-(t480 * t128)).add_product(t130, t489).sub_product(t132, t488).sub_product(t134,
        t487).sub_product(t136, t485);
    let t491 = (t479 * t117).sub_product(t119, t490).sub_product(t121, t489).sub_product(t123, t488)
        .sub_product(t125, t487).sub_product(t127, t485);
    let t492 = (-(t478 * t106).add_product(t108, t491).add_product(t109, t490)).add_product(t110,
        t489).sub_product(t112, t488).sub_product(t114, t487).sub_product(t116, t485);
    let t493 = (t99 * t491).add_product(t97, t492).add_product(t101, t488).add_product(t103, t487)
        .add_product(t105, t485);
    let t494 = (t86 * t492).sub_product(t85, t493).add_product(t88, t491).add_product(t90, t488)
        .add_product(t92, t487).add_product(t94, t485);
    let t495 = (t74 * t493).sub_product(t72, t494).add_product(t77, t488).sub_product(t80, t487)
        .sub_product(t82, t485);
    let t496 = (-(t60 * t494).add_product(t58, t495)).add_product(t61, t493).sub_product(t64, t488)
        .add_product(t66, t487).add_product(t68, t485);
    let t497 = (t51 * t495).add_product(t49, t496).add_product(t53, t485);
    let t498 = (t41 * t496).sub_product(t39, t497).add_product(t39, t495).sub_product(t43, t485);
    let drum_v_y_dot_by_rod_phi = (t34 * t486).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t486);
    let drum_v_x_dot_by_rod_phi = (t33 * t486).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t486);
    let bobbin_v_y_dot_by_rod_phi = -(t32 * t486).add_product(c.inverse_bobbin_mass, t487);
    let bobbin_v_x_dot_by_rod_phi = -(t31 * t486).add_product(c.inverse_bobbin_mass, t488);
    let rod_omega_dot_by_rod_phi = t478.sub_product(R::literal(4_166.666_666_666_667), t492)
        .add_product(t29, t490).sub_product(t30, t489);
    let rod_v_y_dot_by_rod_phi = -(R::literal(5.0) * t489).add_product(t28, t491);
    let rod_v_x_dot_by_rod_phi = (R::literal(-5.0) * t490).add_product(t27, t491);
    let cylinder_omega_dot_by_rod_phi = (-(t25 * t493).add_product(t24, t494))
        .add_product(R::literal(2_777.777_777_777_778), t492).add_product(t26, t491);
    let cylinder_v_y_dot_by_rod_phi = (t23 * t491).add_product(R::literal(3.333_333_333_333_333_5),
        t493);
    let cylinder_v_x_dot_by_rod_phi = -(t22 * t491)
        .add_product(R::literal(3.333_333_333_333_333_5), t494);
    let plate_omega_dot_by_rod_phi = (t19 * t495).sub_product(t18, t496).sub_product(t18, t494)
        .sub_product(t19, t493).add_product(t20, t488).sub_product(t21, t487);
    let plate_v_y_dot_by_rod_phi = (-(R::literal(0.833_333_333_333_333_4) * t493)
        .add_product(R::literal(0.833_333_333_333_333_4), t495))
        .add_product(R::literal(0.833_333_333_333_333_4), t487);
    let plate_v_x_dot_by_rod_phi = (R::literal(0.833_333_333_333_333_4) * t494)
        .sub_product(R::literal(0.833_333_333_333_333_4), t496)
        .add_product(R::literal(0.833_333_333_333_333_4), t488);
    let post_omega_dot_by_rod_phi = (-(t16 * t497).add_product(t15, t498).add_product(t15, t496))
        .add_product(t16, t495).sub_product(t17, t485);
    let post_v_y_dot_by_rod_phi = (R::literal(1.25) * t495).add_product(R::literal(1.25), t497);
    let post_v_x_dot_by_rod_phi = (R::literal(1.25) * t496).sub_product(R::literal(1.25), t498);
    let t499 = t172 * bobbin_y_minus_drum_y / between_squared_times_between;
    let bobbin_x_plus_between_minus_drum_x = bobbin_x + between - drum_x;
    let bobbin_x_minus_drum_x_minus_between = bobbin_x_minus_drum_x - between;
    let t500 = p.winding_force * bobbin_x_plus_between_minus_drum_x
        * bobbin_x_minus_drum_x_minus_between / between_squared_times_between;
    let t501 = R::literal(3.0) * bobbin_v_x;
    let t502 = t501 * bobbin_x_minus_drum_x;
    let t503 = t502 / between_squared_times_between;
    let t504 = between.powi(5);
    let t505 = bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t506 = R::literal(3.0) * drum_v_x;
    let t507 = t506 * t505 / t504;
    let t508 = R::literal(3.0) * drum_v_y;
    let t509 = t508 * bobbin_y_minus_drum_y;
    let t510 = t509 * bobbin_x_minus_drum_x_squared / t504;
    let t511 = bobbin_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t512 = t501 * t505 / t504;
    let t513 = R::literal(3.0) * bobbin_v_y;
    let t514 = t513 * bobbin_y_minus_drum_y;
    let t515 = t514 * bobbin_x_minus_drum_x_squared / t504;
    let t516 = t506 * bobbin_x_minus_drum_x;
    let t517 = t516 / between_squared_times_between;
    let t518 = drum_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t519 = t512 + t515 + t517 + t518 - t503 - t507 - t510 - t511;
    let t520 = t506 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t504;
    let t521 = t508 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t504;
    let t522 = bobbin_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t523 = t195 / between_squared_times_between;
    let t524 = t501 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t504;
    let t525 = t513 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t504;
    let t526 = drum_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t527 = drum_v_y_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t528 = t524 + t525 + t526 + t527 - t520 - t521 - t522 - t523;
    let t529 = t503 + t507 + t510 + t511 - t512 - t515 - t517 - t518;
    let t530 = t520 + t521 + t522 + t523 - t524 - t525 - t526 - t527;
    let t531 = bobbin_x_plus_between_minus_drum_x * bobbin_x_minus_drum_x_minus_between
        / between_squared_times_between;
    let t532 = t531 * t230;
    let t533 = t499 + t532;
    let t534 = t531 * t243;
    let t535 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t536 = t535 * t230;
    let t537 = t536 - t500;
    let t538 = t535 * bobbin_v_y_dot;
    let t539 = t531 * drum_v_x_dot;
    let t540 = t535 * drum_v_y_dot;
    let t541 = c.inverse_bobbin_mass * t533;
    let t542 = c.inverse_bobbin_mass * t537;
    let t543 = t146 * t541;
    let t544 = t543 - t542;
    let t545 = R::literal(0.666_666_666_666_666_6) * t532;
    let t546 = R::literal(0.666_666_666_666_666_6) * t536;
    let t547 = t31 * t533;
    let t548 = t33 * t532;
    let t549 = t34 * t536;
    let t550 = t147 * t541;
    let t551 = bobbin_x_minus_drum_x_over_between * t545;
    let t552 = bobbin_y_minus_drum_y_over_between * t546;
    let t553 = ((t538 - ((bobbin_v_x * t519).add_product(bobbin_v_y, t528).add_product(drum_v_x,
        t529).add_product(drum_v_y, t530) + t534) - t539 - t540 - t547).sub_product(t32, t537)
        - t548 - t549 - t550).sub_product(t152, t544) + t551 + t552;
    let t554 = t149 * t541;
    let t555 = t541 * t144;
    let t556 = t554.sub_product(t154, t544).sub_product(t159, t553) * t160;
    let t557 = (t553 * t157).sub_product(t159, t556);
    let t558 = (t544 * t150).sub_product(t152, t557).sub_product(t154, t556);
    let t559 = (-t555.add_product(t146, t558)).add_product(t147, t557).sub_product(t149, t556);
    let t560 = (t141 * t558).add_product(t139, t559).add_product(t143, t556);
    let t561 = (t132 * t559).add_product(t130, t560).add_product(t134, t558).add_product(t136,
        t556);
    let t562 = (t121 * t560).add_product(t119, t561).sub_product(t123, t559).sub_product(t125, t558)
        .sub_product(t127, t556);
    let t563 = (t109 * t561).sub_product(t108, t562).sub_product(t110, t560).sub_product(t112, t559)
        .sub_product(t114, t558).sub_product(t116, t556);
    let t564 = (t99 * t562).add_product(t97, t563).add_product(t101, t559).add_product(t103, t558)
        .add_product(t105, t556);
    let t565 = (t86 * t563).sub_product(t85, t564).add_product(t88, t562).add_product(t90, t559)
        .add_product(t92, t558).add_product(t94, t556);
    let t566 = (t74 * t564).sub_product(t72, t565).add_product(t77, t559).sub_product(t80, t558)
        .sub_product(t82, t556);
    let t567 = (-(t60 * t565).add_product(t58, t566)).add_product(t61, t564).sub_product(t64, t559)
        .add_product(t66, t558).add_product(t68, t556);
    let t568 = (t51 * t566).add_product(t49, t567).add_product(t53, t556);
    let t569 = (t41 * t567).sub_product(t39, t568).add_product(t39, t566).sub_product(t43, t556);
    let drum_v_y_dot_by_bobbin_x = (-t546.add_product(R::literal(0.666_666_666_666_666_6), (-t536)
        .add_product(bobbin_y_minus_drum_y_over_between, t557))).add_product(t34, t557);
    let drum_v_x_dot_by_bobbin_x = (-t545.add_product(R::literal(0.666_666_666_666_666_6), (-t532)
        .add_product(bobbin_x_minus_drum_x_over_between, t557))).add_product(t33, t557);
    let bobbin_v_y_dot_by_bobbin_x = t542.sub_product(c.inverse_bobbin_mass, t558).sub_product(t32,
        t557);
    let bobbin_v_x_dot_by_bobbin_x = t541.sub_product(c.inverse_bobbin_mass, t559).sub_product(t31,
        t557);
    let rod_omega_dot_by_bobbin_x = (-(t29 * t561).add_product(R::literal(4_166.666_666_666_667),
        t563)).add_product(t30, t560);
    let rod_v_y_dot_by_bobbin_x = (R::literal(5.0) * t560).sub_product(t28, t562);
    let rod_v_x_dot_by_bobbin_x = (R::literal(5.0) * t561).add_product(t27, t562);
    let cylinder_omega_dot_by_bobbin_x = (-(t25 * t564).add_product(t24, t565))
        .add_product(R::literal(2_777.777_777_777_778), t563).add_product(t26, t562);
    let cylinder_v_y_dot_by_bobbin_x = (t23 * t562)
        .add_product(R::literal(3.333_333_333_333_333_5), t564);
    let cylinder_v_x_dot_by_bobbin_x = -(t22 * t562)
        .add_product(R::literal(3.333_333_333_333_333_5), t565);
    let plate_omega_dot_by_bobbin_x = (t19 * t566).sub_product(t18, t567).sub_product(t18, t565)
        .sub_product(t19, t564).add_product(t20, t559).sub_product(t21, t558);
    let plate_v_y_dot_by_bobbin_x = (-(R::literal(0.833_333_333_333_333_4) * t564)
        .add_product(R::literal(0.833_333_333_333_333_4), t566))
        .add_product(R::literal(0.833_333_333_333_333_4), t558);
    let plate_v_x_dot_by_bobbin_x = (R::literal(0.833_333_333_333_333_4) * t565)
        .sub_product(R::literal(0.833_333_333_333_333_4), t567)
        .add_product(R::literal(0.833_333_333_333_333_4), t559);
    let post_omega_dot_by_bobbin_x = (-(t16 * t568).add_product(t15, t569).add_product(t15, t567))
        .add_product(t16, t566).sub_product(t17, t556);
    let post_v_y_dot_by_bobbin_x = (R::literal(1.25) * t566).add_product(R::literal(1.25), t568);
    let post_v_x_dot_by_bobbin_x = (R::literal(1.25) * t567).sub_product(R::literal(1.25), t569);
    let bobbin_y_plus_between_minus_drum_y = bobbin_y + between - drum_y;
    let bobbin_y_minus_drum_y_minus_between = bobbin_y_minus_drum_y - between;
    let t570 = t514 / between_squared_times_between;
    let t571 = t516 * bobbin_y_minus_drum_y_squared / t504;
    let t572 = bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t573 = t508 * t572 / t504;
    let t574 = t199 / between_squared_times_between;
    let t575 = t502 * bobbin_y_minus_drum_y_squared / t504;
    let t576 = t513 * t572 / t504;
    let t577 = t509 / between_squared_times_between;
    let t578 = drum_v_x_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t579 = t575 + t576 + t577 + t578 - t570 - t571 - t573 - t574;
    let t580 = t570 + t571 + t573 + t574 - t575 - t576 - t577 - t578;
    let t581 = p.winding_force * bobbin_y_plus_between_minus_drum_y
        * bobbin_y_minus_drum_y_minus_between / between_squared_times_between + t536;
    let t582 = t535 * t243;
    let t583 = bobbin_y_plus_between_minus_drum_y * bobbin_y_minus_drum_y_minus_between
        / between_squared_times_between;
    let t584 = t583 * t230;
    let t585 = t584 - t499;
    let t586 = t583 * bobbin_v_y_dot;
    let t587 = t535 * drum_v_x_dot;
    let t588 = t583 * drum_v_y_dot;
    let t589 = c.inverse_bobbin_mass * t581;
    let t590 = c.inverse_bobbin_mass * t585;
    let t591 = t146 * t589;
    let t592 = t591 - t590;
    let t593 = R::literal(0.666_666_666_666_666_6) * t584;
    let t594 = t31 * t581;
    let t595 = t33 * t536;
    let t596 = t34 * t584;
    let t597 = t147 * t589;
    let t598 = bobbin_x_minus_drum_x_over_between * t546;
    let t599 = bobbin_y_minus_drum_y_over_between * t593;
    let t600 = ((t586 - ((bobbin_v_x * t528).add_product(bobbin_v_y, t579).add_product(drum_v_x,
        t530).add_product(drum_v_y, t580) + t582) - t587 - t588 - t594).sub_product(t32, t585)
        - t595 - t596 - t597).sub_product(t152, t592) + t598 + t599;
    let t601 = t149 * t589;
    let t602 = t589 * t144;
    let t603 = t601.sub_product(t154, t592).sub_product(t159, t600) * t160;
    let t604 = (t600 * t157).sub_product(t159, t603);
    let t605 = (t592 * t150).sub_product(t152, t604).sub_product(t154, t603);
    let t606 = (-t602.add_product(t146, t605)).add_product(t147, t604).sub_product(t149, t603);
    let t607 = (t141 * t605).add_product(t139, t606).add_product(t143, t603);
    let t608 = (t132 * t606).add_product(t130, t607).add_product(t134, t605).add_product(t136,
        t603);
    let t609 = (t121 * t607).add_product(t119, t608).sub_product(t123, t606).sub_product(t125, t605)
        .sub_product(t127, t603);
    let t610 = (t109 * t608).sub_product(t108, t609).sub_product(t110, t607).sub_product(t112, t606)
        .sub_product(t114, t605).sub_product(t116, t603);
    let t611 = (t99 * t609).add_product(t97, t610).add_product(t101, t606).add_product(t103, t605)
        .add_product(t105, t603);
    let t612 = (t86 * t610).sub_product(t85, t611).add_product(t88, t609).add_product(t90, t606)
        .add_product(t92, t605).add_product(t94, t603);
    let t613 = (t74 * t611).sub_product(t72, t612).add_product(t77, t606).sub_product(t80, t605)
        .sub_product(t82, t603);
    let t614 = (-(t60 * t612).add_product(t58, t613)).add_product(t61, t611).sub_product(t64, t606)
        .add_product(t66, t605).add_product(t68, t603);
    let t615 = (t51 * t613).add_product(t49, t614).add_product(t53, t603);
    let t616 = (t41 * t614).sub_product(t39, t615).add_product(t39, t613).sub_product(t43, t603);
    let drum_v_y_dot_by_bobbin_y = (-t593.add_product(R::literal(0.666_666_666_666_666_6), (-t584)
        .add_product(bobbin_y_minus_drum_y_over_between, t604))).add_product(t34, t604);
    let drum_v_x_dot_by_bobbin_y = (-t546.add_product(R::literal(0.666_666_666_666_666_6), (-t536)
        .add_product(bobbin_x_minus_drum_x_over_between, t604))).add_product(t33, t604);
    let bobbin_v_y_dot_by_bobbin_y = t590.sub_product(c.inverse_bobbin_mass, t605).sub_product(t32,
        t604);
    let bobbin_v_x_dot_by_bobbin_y = t589.sub_product(c.inverse_bobbin_mass, t606).sub_product(t31,
        t604);
    let rod_omega_dot_by_bobbin_y = (-(t29 * t608).add_product(R::literal(4_166.666_666_666_667),
        t610)).add_product(t30, t607);
    let rod_v_y_dot_by_bobbin_y = (R::literal(5.0) * t607).sub_product(t28, t609);
    let rod_v_x_dot_by_bobbin_y = (R::literal(5.0) * t608).add_product(t27, t609);
    let cylinder_omega_dot_by_bobbin_y = (-(t25 * t611).add_product(t24, t612))
        .add_product(R::literal(2_777.777_777_777_778), t610).add_product(t26, t609);
    let cylinder_v_y_dot_by_bobbin_y = (t23 * t609)
        .add_product(R::literal(3.333_333_333_333_333_5), t611);
    let cylinder_v_x_dot_by_bobbin_y = -(t22 * t609)
        .add_product(R::literal(3.333_333_333_333_333_5), t612);
    let plate_omega_dot_by_bobbin_y = (t19 * t613).sub_product(t18, t614).sub_product(t18, t612)
        .sub_product(t19, t611).add_product(t20, t606).sub_product(t21, t605);
    let plate_v_y_dot_by_bobbin_y = (-(R::literal(0.833_333_333_333_333_4) * t611)
        .add_product(R::literal(0.833_333_333_333_333_4), t613))
        .add_product(R::literal(0.833_333_333_333_333_4), t605);
    let plate_v_x_dot_by_bobbin_y = (R::literal(0.833_333_333_333_333_4) * t612)
        .sub_product(R::literal(0.833_333_333_333_333_4), t614)
        .add_product(R::literal(0.833_333_333_333_333_4), t606);
    let post_omega_dot_by_bobbin_y = (-(t16 * t615).add_product(t15, t616).add_product(t15, t614))
        .add_product(t16, t613).sub_product(t17, t603);
    let post_v_y_dot_by_bobbin_y = (R::literal(1.25) * t613).add_product(R::literal(1.25), t615);
    let post_v_x_dot_by_bobbin_y = (R::literal(1.25) * t614).sub_product(R::literal(1.25), t616);
    let t617 = t500 - t536;
    let t618 = c.inverse_bobbin_mass * t617;
    let t619 = t618 + t543;
    let t620 = ((t534 - (bobbin_v_y * t530).add_product(bobbin_v_x, t529).add_product(drum_v_x,
        t519).add_product(drum_v_y, t528) - t538 + t539 + t540 + t547).sub_product(t32, t617)
        + t548 + t549 + t550).add_product(t152, t619) - t551 - t552;
    let t621 = (-t554).add_product(t154, t619).sub_product(t159, t620) * t160;
    let t622 = (t620 * t157).sub_product(t159, t621);
    let t623 = (t619 * t150).add_product(t152, t622).add_product(t154, t621);
    let t624 = t555.add_product(t146, t623).add_product(t147, t622).sub_product(t149, t621);
    let t625 = (t141 * t623).sub_product(t139, t624).sub_product(t143, t621);
    let t626 = (-(t132 * t624)).add_product(t130, t625).add_product(t134, t623).sub_product(t136,
        t621);
    let t627 = (-(t121 * t625).add_product(t119, t626).add_product(t123, t624)).add_product(t125,
        t623).sub_product(t127, t621);
    let t628 = (-(t109 * t626).add_product(t108, t627)).add_product(t110, t625).sub_product(t112,
        t624).add_product(t114, t623).sub_product(t116, t621);
    let t629 = (-(t99 * t627).add_product(t97, t628).add_product(t101, t624)).add_product(t103,
        t623).sub_product(t105, t621);
    let t630 = (t86 * t628).add_product(t85, t629).add_product(t88, t627).add_product(t90, t624)
        .sub_product(t92, t623).add_product(t94, t621);
    let t631 = (-(t74 * t629).add_product(t72, t630)).add_product(t77, t624).add_product(t80, t623)
        .sub_product(t82, t621);
    let t632 = (-(t60 * t630).add_product(t58, t631).add_product(t61, t629).add_product(t64, t624)
        .add_product(t66, t623)).add_product(t68, t621);
    let t633 = (t51 * t631).add_product(t49, t632).add_product(t53, t621);
    let t634 = (t41 * t632).sub_product(t39, t633).add_product(t39, t631).sub_product(t43, t621);
    let drum_v_y_dot_by_drum_x = t546.sub_product(R::literal(0.666_666_666_666_666_6), t536
        .add_product(bobbin_y_minus_drum_y_over_between, t622)).add_product(t34, t622);
    let drum_v_x_dot_by_drum_x = t545.sub_product(R::literal(0.666_666_666_666_666_6), t532
        .add_product(bobbin_x_minus_drum_x_over_between, t622)).add_product(t33, t622);
    let bobbin_v_y_dot_by_drum_x = t618.add_product(c.inverse_bobbin_mass, t623).sub_product(t32,
        t622);
    let bobbin_v_x_dot_by_drum_x = -t541.add_product(c.inverse_bobbin_mass, t624).add_product(t31,
        t622);
    let rod_omega_dot_by_drum_x = (t29 * t626).sub_product(R::literal(4_166.666_666_666_667), t628)
        .sub_product(t30, t625);
    let rod_v_y_dot_by_drum_x = -(R::literal(5.0) * t625).add_product(t28, t627);
    let rod_v_x_dot_by_drum_x = (R::literal(-5.0) * t626).add_product(t27, t627);
    let cylinder_omega_dot_by_drum_x = (t25 * t629).sub_product(t24, t630)
        .add_product(R::literal(2_777.777_777_777_778), t628).add_product(t26, t627);
    let cylinder_v_y_dot_by_drum_x = (t23 * t627).sub_product(R::literal(3.333_333_333_333_333_5),
        t629);
    let cylinder_v_x_dot_by_drum_x = -(t22 * t627).add_product(R::literal(3.333_333_333_333_333_5),
        t630);
    let plate_omega_dot_by_drum_x = (t19 * t631).sub_product(t18, t632).sub_product(t18, t630)
        .add_product(t19, t629).add_product(t20, t624).add_product(t21, t623);
    let plate_v_y_dot_by_drum_x = (R::literal(0.833_333_333_333_333_4) * t629)
        .sub_product(R::literal(0.833_333_333_333_333_4), t631)
        .sub_product(R::literal(0.833_333_333_333_333_4), t623);
    let plate_v_x_dot_by_drum_x = (R::literal(0.833_333_333_333_333_4) * t630)
        .sub_product(R::literal(0.833_333_333_333_333_4), t632)
        .add_product(R::literal(0.833_333_333_333_333_4), t624);
    let post_omega_dot_by_drum_x = (-(t16 * t633).add_product(t15, t634).add_product(t15, t632))
        .add_product(t16, t631).sub_product(t17, t621);
    let post_v_y_dot_by_drum_x = (R::literal(1.25) * t631).add_product(R::literal(1.25), t633);
    let post_v_x_dot_by_drum_x = (R::literal(1.25) * t632).sub_product(R::literal(1.25), t634);
    let t635 = t499 - t584;
    let t636 = c.inverse_bobbin_mass * t635;
    let t637 = t636 + t591;
    let t638 = ((t582 - (bobbin_v_x * t530).add_product(bobbin_v_y, t580).add_product(drum_v_x,
        t528).add_product(drum_v_y, t579) - t586 + t587 + t588 + t594).sub_product(t32, t635)
        + t595 + t596 + t597).add_product(t152, t637) - t598 - t599;
    let t639 = (-t601).add_product(t154, t637).sub_product(t159, t638) * t160;
    let t640 = (t638 * t157).sub_product(t159, t639);
    let t641 = (t637 * t150).add_product(t152, t640).add_product(t154, t639);
    let t642 = t602.add_product(t146, t641).add_product(t147, t640).sub_product(t149, t639);
    let t643 = (t141 * t641).sub_product(t139, t642).sub_product(t143, t639);
    let t644 = (-(t132 * t642)).add_product(t130, t643).add_product(t134, t641).sub_product(t136,
        t639);
    let t645 = (-(t121 * t643).add_product(t119, t644).add_product(t123, t642)).add_product(t125,
        t641).sub_product(t127, t639);
    let t646 = (-(t109 * t644).add_product(t108, t645)).add_product(t110, t643).sub_product(t112,
        t642).add_product(t114, t641).sub_product(t116, t639);
    let t647 = (-(t99 * t645).add_product(t97, t646).add_product(t101, t642)).add_product(t103,
        t641).sub_product(t105, t639);
    let t648 = (t86 * t646).add_product(t85, t647).add_product(t88, t645).add_product(t90, t642)
        .sub_product(t92, t641).add_product(t94, t639);
    let t649 = (-(t74 * t647).add_product(t72, t648)).add_product(t77, t642).add_product(t80, t641)
        .sub_product(t82, t639);
    let t650 = (-(t60 * t648).add_product(t58, t649).add_product(t61, t647).add_product(t64, t642)
        .add_product(t66, t641)).add_product(t68, t639);
    let t651 = (t51 * t649).add_product(t49, t650).add_product(t53, t639);
    let t652 = (t41 * t650).sub_product(t39, t651).add_product(t39, t649).sub_product(t43, t639);
    let drum_v_y_dot_by_drum_y = t593.sub_product(R::literal(0.666_666_666_666_666_6), t584
        .add_product(bobbin_y_minus_drum_y_over_between, t640)).add_product(t34, t640);
    let drum_v_x_dot_by_drum_y = t546.sub_product(R::literal(0.666_666_666_666_666_6), t536
        .add_product(bobbin_x_minus_drum_x_over_between, t640)).add_product(t33, t640);
    let bobbin_v_y_dot_by_drum_y = t636.add_product(c.inverse_bobbin_mass, t641).sub_product(t32,
        t640);
    let bobbin_v_x_dot_by_drum_y = -t589.add_product(c.inverse_bobbin_mass, t642).add_product(t31,
        t640);
    let rod_omega_dot_by_drum_y = (t29 * t644).sub_product(R::literal(4_166.666_666_666_667), t646)
        .sub_product(t30, t643);
    let rod_v_y_dot_by_drum_y = -(R::literal(5.0) * t643).add_product(t28, t645);
    let rod_v_x_dot_by_drum_y = (R::literal(-5.0) * t644).add_product(t27, t645);
    let cylinder_omega_dot_by_drum_y = (t25 * t647).sub_product(t24, t648)
        .add_product(R::literal(2_777.777_777_777_778), t646).add_product(t26, t645);
    let cylinder_v_y_dot_by_drum_y = (t23 * t645).sub_product(R::literal(3.333_333_333_333_333_5),
        t647);
    let cylinder_v_x_dot_by_drum_y = -(t22 * t645).add_product(R::literal(3.333_333_333_333_333_5),
        t648);
    let plate_omega_dot_by_drum_y = (t19 * t649).sub_product(t18, t650).sub_product(t18, t648)
        .add_product(t19, t647).add_product(t20, t642).add_product(t21, t641);
    let plate_v_y_dot_by_drum_y = (R::literal(0.833_333_333_333_333_4) * t647)
        .sub_product(R::literal(0.833_333_333_333_333_4), t649)
        .sub_product(R::literal(0.833_333_333_333_333_4), t641);
    let plate_v_x_dot_by_drum_y = (R::literal(0.833_333_333_333_333_4) * t648)
        .sub_product(R::literal(0.833_333_333_333_333_4), t650)
        .add_product(R::literal(0.833_333_333_333_333_4), t642);
    let post_omega_dot_by_drum_y = (-(t16 * t651).add_product(t15, t652).add_product(t15, t650))
        .add_product(t16, t649).sub_product(t17, t639);
    let post_v_y_dot_by_drum_y = (R::literal(1.25) * t649).add_product(R::literal(1.25), t651);
    let post_v_x_dot_by_drum_y = (R::literal(1.25) * t650).sub_product(R::literal(1.25), t652);
    let t653 = R::literal(0.2) * post_omega;
    let t654 = t653 * cos_post_phi;
    let t655 = (t653 * sin_post_phi).add_product(t39, t654);
    let t656 = (-t654.add_product(t41, t654)).add_product(t49, t655);
    let t657 = (-t655).add_product(t51, t655).sub_product(t58, t656);
    let t658 = (t60 * t656).add_product(t72, t657);
    let t659 = (t61 * t656).add_product(t74, t657).add_product(t85, t658);
    let t660 = (-(t86 * t658)).add_product(t97, t659);
    let t661 = (-(t88 * t658)).add_product(t99, t659).sub_product(t108, t660);
    let t662 = (t109 * t660).add_product(t119, t661);
    let t663 = (t110 * t660).sub_product(t121, t661).sub_product(t130, t662);
    let t664 = (-(t64 * t656)).add_product(t77, t657).sub_product(t90, t658).add_product(t101, t659)
        .sub_product(t112, t660).sub_product(t123, t661).add_product(t132, t662).sub_product(t139,
        t663);
    let t665 = (t66 * t656).sub_product(t80, t657).sub_product(t92, t658).add_product(t103, t659)
        .sub_product(t114, t660).sub_product(t125, t661).add_product(t134, t662).sub_product(t141,
        t663).sub_product(t146, t664);
    let t666 = (t147 * t664).sub_product(t152, t665);
    let t667 = (post_omega * (R::literal(0.286) * sin_post_phi).sub_product(R::literal(0.088),
        cos_post_phi)).add_product(t43, t654).add_product(t53, t655).add_product(t68, t656)
        .sub_product(t82, t657).sub_product(t94, t658).add_product(t105, t659).sub_product(t116,
        t660).sub_product(t127, t661).add_product(t136, t662).sub_product(t143, t663)
        .sub_product(t149, t664).sub_product(t154, t665).sub_product(t159, t666) * t160;
    let t668 = (t666 * t157).sub_product(t159, t667);
    let t669 = (t665 * t150).sub_product(t152, t668).sub_product(t154, t667);
    let t670 = (t664 * t144).sub_product(t146, t669).add_product(t147, t668).sub_product(t149,
        t667);
    let t671 = (t663 * t137).sub_product(t139, t670).sub_product(t141, t669).sub_product(t143,
        t667);
    let t672 = (t662 * t128).add_product(t130, t671).sub_product(t132, t670).sub_product(t134, t669)
        .sub_product(t136, t667);
    let t673 = (t661 * t117).sub_product(t119, t672).sub_product(t121, t671).sub_product(t123, t670)
        .sub_product(t125, t669).sub_product(t127, t667);
    let t674 = (t660 * t106).sub_product(t108, t673).sub_product(t109, t672).add_product(t110, t671)
        .sub_product(t112, t670).sub_product(t114, t669).sub_product(t116, t667);
    let t675 = (t659 * t95).add_product(t97, t674).add_product(t99, t673).add_product(t101, t670)
        .add_product(t103, t669).add_product(t105, t667);
    let t676 = (t658 * t83).sub_product(t85, t675).add_product(t86, t674).add_product(t88, t673)
        .add_product(t90, t670).add_product(t92, t669).add_product(t94, t667);
    let t677 = (t657 * t70).sub_product(t72, t676).add_product(t74, t675).add_product(t77, t670)
        .sub_product(t80, t669).sub_product(t82, t667);
    let t678 = (t656 * t55).sub_product(t58, t677).sub_product(t60, t676).add_product(t61, t675)
        .sub_product(t64, t670).add_product(t66, t669).add_product(t68, t667);
    let t679 = (t655 * t47).add_product(t49, t678).add_product(t51, t677).add_product(t53, t667);
    let t680 = (t654 * t37).sub_product(t39, t679).add_product(t41, t678).add_product(t39, t677)
        .sub_product(t43, t667);
    let drum_v_y_dot_by_post_omega = (t34 * t668).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t668);
    let drum_v_x_dot_by_post_omega = (t33 * t668).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t668);
    let bobbin_v_y_dot_by_post_omega = -(t32 * t668).add_product(c.inverse_bobbin_mass, t669);
    let bobbin_v_x_dot_by_post_omega = -(t31 * t668).add_product(c.inverse_bobbin_mass, t670);
    let rod_omega_dot_by_post_omega = (t29 * t672).sub_product(R::literal(4_166.666_666_666_667),
        t674).sub_product(t30, t671);
    let rod_v_y_dot_by_post_omega = -(R::literal(5.0) * t671).add_product(t28, t673);
    let rod_v_x_dot_by_post_omega = (R::literal(-5.0) * t672).add_product(t27, t673);
    let cylinder_omega_dot_by_post_omega = (-(t25 * t675).add_product(t24, t676))
        .add_product(R::literal(2_777.777_777_777_778), t674).add_product(t26, t673);
    let cylinder_v_y_dot_by_post_omega = (t23 * t673)
        .add_product(R::literal(3.333_333_333_333_333_5), t675);
    let cylinder_v_x_dot_by_post_omega = -(t22 * t673)
        .add_product(R::literal(3.333_333_333_333_333_5), t676);
    let plate_omega_dot_by_post_omega = (t19 * t677).sub_product(t18, t678).sub_product(t18, t676)
        .sub_product(t19, t675).add_product(t20, t670).sub_product(t21, t669);
    let plate_v_y_dot_by_post_omega = (-(R::literal(0.833_333_333_333_333_4) * t675)
        .add_product(R::literal(0.833_333_333_333_333_4), t677))
        .add_product(R::literal(0.833_333_333_333_333_4), t669);
    let plate_v_x_dot_by_post_omega = (R::literal(0.833_333_333_333_333_4) * t676)
        .sub_product(R::literal(0.833_333_333_333_333_4), t678)
        .add_product(R::literal(0.833_333_333_333_333_4), t670);
    let post_omega_dot_by_post_omega = (-(t16 * t679).add_product(t15, t680).add_product(t15, t678))
        .add_product(t16, t677).sub_product(t17, t667);
    let post_v_y_dot_by_post_omega = (R::literal(1.25) * t677).add_product(R::literal(1.25), t679);
    let post_v_x_dot_by_post_omega = (R::literal(1.25) * t678).sub_product(R::literal(1.25), t680);
    let t681 = R::literal(0.12) * plate_omega;
    let t682 = t681 * cos_plate_phi;
    let t683 = t681 * sin_plate_phi;
    let t684 = (-t683).add_product(t58, t682);
    let t685 = (-t682).add_product(t60, t682).sub_product(t72, t684);
    let t686 = (-t683).add_product(t61, t682).sub_product(t74, t684).add_product(t85, t685);
    let t687 = (t86 * t685).sub_product(t97, t686);
    let t688 = (t88 * t685).sub_product(t99, t686).sub_product(t108, t687);
    let t689 = (t109 * t687).add_product(t119, t688);
    let t690 = (t110 * t687).sub_product(t121, t688).sub_product(t130, t689);
    let t691 = (plate_omega * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2),
        sin_plate_phi)).add_product(t64, t682).add_product(t77, t684).add_product(t90, t685)
        .sub_product(t101, t686).sub_product(t112, t687).sub_product(t123, t688).add_product(t132,
        t689).sub_product(t139, t690);
    let t692 = (plate_omega * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2),
        cos_plate_phi)).sub_product(t66, t682).sub_product(t80, t684).add_product(t92, t685)
        .sub_product(t103, t686).sub_product(t114, t687).sub_product(t125, t688).add_product(t134,
        t689).sub_product(t141, t690).sub_product(t146, t691);
    let t693 = (t147 * t691).sub_product(t152, t692);
    let t694 = (-(t68 * t682).add_product(t82, t684)).add_product(t94, t685).sub_product(t105, t686)
        .sub_product(t116, t687).sub_product(t127, t688).add_product(t136, t689).sub_product(t143,
        t690).sub_product(t149, t691).sub_product(t154, t692).sub_product(t159, t693) * t160;
    let t695 = (t693 * t157).sub_product(t159, t694);
    let t696 = (t692 * t150).sub_product(t152, t695).sub_product(t154, t694);
    let t697 = (t691 * t144).sub_product(t146, t696).add_product(t147, t695).sub_product(t149,
        t694);
    let t698 = (t690 * t137).sub_product(t139, t697).sub_product(t141, t696).sub_product(t143,
        t694);
    let t699 = (t689 * t128).add_product(t130, t698).sub_product(t132, t697).sub_product(t134, t696)
        .sub_product(t136, t694);
    let t700 = (t688 * t117).sub_product(t119, t699).sub_product(t121, t698).sub_product(t123, t697)
        .sub_product(t125, t696).sub_product(t127, t694);
    let t701 = (t687 * t106).sub_product(t108, t700).sub_product(t109, t699).add_product(t110, t698)
        .sub_product(t112, t697).sub_product(t114, t696).sub_product(t116, t694);
    let t702 = (t686 * t95).sub_product(t97, t701).sub_product(t99, t700).sub_product(t101, t697)
        .sub_product(t103, t696).sub_product(t105, t694);
    let t703 = (-(t685 * t83)).add_product(t85, t702).add_product(t86, t701).add_product(t88, t700)
        .add_product(t90, t697).add_product(t92, t696).add_product(t94, t694);
    let t704 = (t684 * t70).sub_product(t72, t703).sub_product(t74, t702).add_product(t77, t697)
        .sub_product(t80, t696).sub_product(t82, t694);
    let t705 = (-(t682 * t55).add_product(t58, t704).add_product(t60, t703).add_product(t61, t702)
        .add_product(t64, t697)).add_product(t66, t696).add_product(t68, t694);
    let t706 = (t51 * t704).add_product(t49, t705).add_product(t53, t694);
    let t707 = (t41 * t705).sub_product(t39, t706).add_product(t39, t704).sub_product(t43, t694);
    let drum_v_y_dot_by_plate_omega = (t34 * t695).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t695);
    let drum_v_x_dot_by_plate_omega = (t33 * t695).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t695);
    let bobbin_v_y_dot_by_plate_omega = -(t32 * t695).add_product(c.inverse_bobbin_mass, t696);
    let bobbin_v_x_dot_by_plate_omega = -(t31 * t695).add_product(c.inverse_bobbin_mass, t697);
    let rod_omega_dot_by_plate_omega = (t29 * t699).sub_product(R::literal(4_166.666_666_666_667),
        t701).sub_product(t30, t698);
    let rod_v_y_dot_by_plate_omega = -(R::literal(5.0) * t698).add_product(t28, t700);
    let rod_v_x_dot_by_plate_omega = (R::literal(-5.0) * t699).add_product(t27, t700);
    let cylinder_omega_dot_by_plate_omega = (t25 * t702).sub_product(t24, t703)
        .add_product(R::literal(2_777.777_777_777_778), t701).add_product(t26, t700);
    let cylinder_v_y_dot_by_plate_omega = (t23 * t700)
        .sub_product(R::literal(3.333_333_333_333_333_5), t702);
    let cylinder_v_x_dot_by_plate_omega = -(t22 * t700)
        .add_product(R::literal(3.333_333_333_333_333_5), t703);
    let plate_omega_dot_by_plate_omega = (t19 * t704).sub_product(t18, t705).sub_product(t18, t703)
        .add_product(t19, t702).add_product(t20, t697).sub_product(t21, t696);
    let plate_v_y_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t702)
        .sub_product(R::literal(0.833_333_333_333_333_4), t704)
        .add_product(R::literal(0.833_333_333_333_333_4), t696);
    let plate_v_x_dot_by_plate_omega = (R::literal(0.833_333_333_333_333_4) * t703)
        .sub_product(R::literal(0.833_333_333_333_333_4), t705)
        .add_product(R::literal(0.833_333_333_333_333_4), t697);
    let post_omega_dot_by_plate_omega = (-(t16 * t706).add_product(t15, t707).add_product(t15,
        t705)).add_product(t16, t704).sub_product(t17, t694);
    let post_v_y_dot_by_plate_omega = (R::literal(1.25) * t704).add_product(R::literal(1.25), t706);
    let post_v_x_dot_by_plate_omega = (R::literal(1.25) * t705).sub_product(R::literal(1.25), t707);
    let cos_cylinder_phi_squared = cos_cylinder_phi * cos_cylinder_phi;
    let t708 = R::literal(50.0) * cos_cylinder_phi_squared;
    let t709 = R::literal(50.0) * sin_cylinder_phi * cos_cylinder_phi;
    let t710 = R::literal(50.0) * t10;
    let t711 = t710 * cos_cylinder_phi;
    let t712 = R::literal(2.0) * cylinder_omega;
    let t713 = t712 * cos_cylinder_phi;
    let t714 = R::literal(166.666_666_666_666_69) * cos_cylinder_phi_squared;
    let t715 = t24 * t711;
    let t716 = t714 - t715;
    let t717 = R::literal(3.333_333_333_333_333_5) * t709;
    let t718 = t717.add_product(t25, t711);
    let t719 = t718.add_product(t85, t716);
    let t720 = R::literal(2_777.777_777_777_778) * t711;
    let t721 = t720.add_product(t86, t716).sub_product(t97, t719);
    let t722 = t22 * t708;
    let t723 = t23 * t709;
    let t724 = t26 * t711;
    let t725 = t27 * t708;
    let t726 = t28 * t709;
    let t727 = (t722 - t713 - t723 + t724 + t725 - t726).add_product(t88, t716).sub_product(t99,
        t719).sub_product(t108, t721);
    let t728 = R::literal(250.0) * cos_cylinder_phi_squared;
    let t729 = t728.add_product(t109, t721).add_product(t119, t727);
    let t730 = R::literal(5.0) * t709;
    let t731 = (-t730).add_product(t110, t721).sub_product(t121, t727).sub_product(t130, t729);
    let t732 = (t90 * t716).sub_product(t101, t719).sub_product(t112, t721).sub_product(t123, t727)
        .add_product(t132, t729).sub_product(t139, t731);
    let t733 = (t92 * t716).sub_product(t103, t719).sub_product(t114, t721).sub_product(t125, t727)
        .add_product(t134, t729).sub_product(t141, t731).sub_product(t146, t732);
    let t734 = (t147 * t732).sub_product(t152, t733);
    let t735 = (t94 * t716).sub_product(t105, t719).sub_product(t116, t721).sub_product(t127, t727)
        .add_product(t136, t729).sub_product(t143, t731).sub_product(t149, t732).sub_product(t154,
        t733).sub_product(t159, t734) * t160;
    let t736 = (t734 * t157).sub_product(t159, t735);
    let t737 = (t733 * t150).sub_product(t152, t736).sub_product(t154, t735);
    let t738 = (t732 * t144).sub_product(t146, t737).add_product(t147, t736).sub_product(t149,
        t735);
    let t739 = (t731 * t137).sub_product(t139, t738).sub_product(t141, t737).sub_product(t143,
        t735);
    let t740 = (t729 * t128).add_product(t130, t739).sub_product(t132, t738).sub_product(t134, t737)
        .sub_product(t136, t735);
    let t741 = (t727 * t117).sub_product(t119, t740).sub_product(t121, t739).sub_product(t123, t738)
        .sub_product(t125, t737).sub_product(t127, t735);
    let t742 = (t721 * t106).sub_product(t108, t741).sub_product(t109, t740).add_product(t110, t739)
        .sub_product(t112, t738).sub_product(t114, t737).sub_product(t116, t735);
    let t743 = (t719 * t95).sub_product(t97, t742).sub_product(t99, t741).sub_product(t101, t738)
        .sub_product(t103, t737).sub_product(t105, t735);
    let t744 = (-(t716 * t83)).add_product(t85, t743).add_product(t86, t742).add_product(t88, t741)
        .add_product(t90, t738).add_product(t92, t737).add_product(t94, t735);
    let t745 = (-(t74 * t743).add_product(t72, t744)).add_product(t77, t738).sub_product(t80, t737)
        .sub_product(t82, t735);
    let t746 = (-(t60 * t744).add_product(t58, t745).add_product(t61, t743).add_product(t64, t738))
        .add_product(t66, t737).add_product(t68, t735);
    let t747 = (t51 * t745).add_product(t49, t746).add_product(t53, t735);
    let t748 = (t41 * t746).sub_product(t39, t747).add_product(t39, t745).sub_product(t43, t735);
    let drum_v_y_dot_by_cylinder_v_x = (t34 * t736)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t736);
    let drum_v_x_dot_by_cylinder_v_x = (t33 * t736)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t736);
    let bobbin_v_y_dot_by_cylinder_v_x = -(t32 * t736).add_product(c.inverse_bobbin_mass, t737);
    let bobbin_v_x_dot_by_cylinder_v_x = -(t31 * t736).add_product(c.inverse_bobbin_mass, t738);
    let rod_omega_dot_by_cylinder_v_x = (t29 * t740).sub_product(R::literal(4_166.666_666_666_667),
        t742).sub_product(t30, t739);
    let rod_v_y_dot_by_cylinder_v_x = t730.sub_product(t28, t741).sub_product(R::literal(5.0),
        t739);
    let rod_v_x_dot_by_cylinder_v_x = t728.add_product(t27, t741).sub_product(R::literal(5.0),
        t740);
    let cylinder_omega_dot_by_cylinder_v_x = t720.sub_product(t24, t744).add_product(t25, t743)
        .add_product(R::literal(2_777.777_777_777_778), t742).add_product(t26, t741);
    let cylinder_v_y_dot_by_cylinder_v_x = (-t717.add_product(R::literal(3.333_333_333_333_333_5),
        t743)).add_product(t23, t741);
    let cylinder_v_x_dot_by_cylinder_v_x = -t714.add_product(R::literal(3.333_333_333_333_333_5),
        t744).add_product(t22, t741);
    let plate_omega_dot_by_cylinder_v_x = (t19 * t745).sub_product(t18, t746).sub_product(t18, t744)
        .add_product(t19, t743).add_product(t20, t738).sub_product(t21, t737);
    let plate_v_y_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t743)
        .sub_product(R::literal(0.833_333_333_333_333_4), t745)
        .add_product(R::literal(0.833_333_333_333_333_4), t737);
    let plate_v_x_dot_by_cylinder_v_x = (R::literal(0.833_333_333_333_333_4) * t744)
        .sub_product(R::literal(0.833_333_333_333_333_4), t746)
        .add_product(R::literal(0.833_333_333_333_333_4), t738);
    let post_omega_dot_by_cylinder_v_x = (-(t16 * t747).add_product(t15, t748).add_product(t15,
        t746)).add_product(t16, t745).sub_product(t17, t735);
    let post_v_y_dot_by_cylinder_v_x = (R::literal(1.25) * t745).add_product(R::literal(1.25),
        t747);
    let post_v_x_dot_by_cylinder_v_x = (R::literal(1.25) * t746).sub_product(R::literal(1.25),
        t748);
    let sin_cylinder_phi_squared = sin_cylinder_phi * sin_cylinder_phi;
    let t749 = R::literal(50.0) * sin_cylinder_phi_squared;
    let t750 = t710 * sin_cylinder_phi;
    let t751 = t712 * sin_cylinder_phi;
    let t752 = t24 * t750;
    let t753 = t717 - t752;
    let t754 = R::literal(166.666_666_666_666_69) * sin_cylinder_phi_squared;
    let t755 = t754.add_product(t25, t750);
    let t756 = t755.add_product(t85, t753);
    let t757 = R::literal(2_777.777_777_777_778) * t750;
    let t758 = t757.add_product(t86, t753).sub_product(t97, t756);
    let t759 = t22 * t709;
    let t760 = t23 * t749;
    let t761 = t26 * t750;
    let t762 = t27 * t709;
    let t763 = t28 * t749;
    let t764 = (t759 - t751 - t760 + t761 + t762 - t763).add_product(t88, t753).sub_product(t99,
        t756).sub_product(t108, t758);
    let t765 = t730.add_product(t109, t758).add_product(t119, t764);
    let t766 = R::literal(250.0) * sin_cylinder_phi_squared;
    let t767 = (-t766).add_product(t110, t758).sub_product(t121, t764).sub_product(t130, t765);
    let t768 = (t90 * t753).sub_product(t101, t756).sub_product(t112, t758).sub_product(t123, t764)
        .add_product(t132, t765).sub_product(t139, t767);
    let t769 = (t92 * t753).sub_product(t103, t756).sub_product(t114, t758).sub_product(t125, t764)
        .add_product(t134, t765).sub_product(t141, t767).sub_product(t146, t768);
    let t770 = (t147 * t768).sub_product(t152, t769);
    let t771 = (t94 * t753).sub_product(t105, t756).sub_product(t116, t758).sub_product(t127, t764)
        .add_product(t136, t765).sub_product(t143, t767).sub_product(t149, t768).sub_product(t154,
        t769).sub_product(t159, t770) * t160;
    let t772 = (t770 * t157).sub_product(t159, t771);
    let t773 = (t769 * t150).sub_product(t152, t772).sub_product(t154, t771);
    let t774 = (t768 * t144).sub_product(t146, t773).add_product(t147, t772).sub_product(t149,
        t771);
    let t775 = (t767 * t137).sub_product(t139, t774).sub_product(t141, t773).sub_product(t143,
        t771);
    let t776 = (t765 * t128).add_product(t130, t775).sub_product(t132, t774).sub_product(t134, t773)
        .sub_product(t136, t771);
    let t777 = (t764 * t117).sub_product(t119, t776).sub_product(t121, t775).sub_product(t123, t774)
        .sub_product(t125, t773).sub_product(t127, t771);
    let t778 = (t758 * t106).sub_product(t108, t777).sub_product(t109, t776).add_product(t110, t775)
        .sub_product(t112, t774).sub_product(t114, t773).sub_product(t116, t771);
    let t779 = (t756 * t95).sub_product(t97, t778).sub_product(t99, t777).sub_product(t101, t774)
        .sub_product(t103, t773).sub_product(t105, t771);
    let t780 = (-(t753 * t83)).add_product(t85, t779).add_product(t86, t778).add_product(t88, t777)
        .add_product(t90, t774).add_product(t92, t773).add_product(t94, t771);
    let t781 = (-(t74 * t779).add_product(t72, t780)).add_product(t77, t774).sub_product(t80, t773)
        .sub_product(t82, t771);
    let t782 = (-(t60 * t780).add_product(t58, t781).add_product(t61, t779).add_product(t64, t774))
        .add_product(t66, t773).add_product(t68, t771);
    let t783 = (t51 * t781).add_product(t49, t782).add_product(t53, t771);
    let t784 = (t41 * t782).sub_product(t39, t783).add_product(t39, t781).sub_product(t43, t771);
    let drum_v_y_dot_by_cylinder_v_y = (t34 * t772)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t772);
    let drum_v_x_dot_by_cylinder_v_y = (t33 * t772)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t772);
    let bobbin_v_y_dot_by_cylinder_v_y = -(t32 * t772).add_product(c.inverse_bobbin_mass, t773);
    let bobbin_v_x_dot_by_cylinder_v_y = -(t31 * t772).add_product(c.inverse_bobbin_mass, t774);
    let rod_omega_dot_by_cylinder_v_y = (t29 * t776).sub_product(R::literal(4_166.666_666_666_667),
        t778).sub_product(t30, t775);
    let rod_v_y_dot_by_cylinder_v_y = t766.sub_product(t28, t777).sub_product(R::literal(5.0),
        t775);
    let rod_v_x_dot_by_cylinder_v_y = t730.add_product(t27, t777).sub_product(R::literal(5.0),
        t776);
    let cylinder_omega_dot_by_cylinder_v_y = t757.sub_product(t24, t780).add_product(t25, t779)
        .add_product(R::literal(2_777.777_777_777_778), t778).add_product(t26, t777);
    let cylinder_v_y_dot_by_cylinder_v_y = (-t754.add_product(R::literal(3.333_333_333_333_333_5),
        t779)).add_product(t23, t777);
    let cylinder_v_x_dot_by_cylinder_v_y = -t717.add_product(R::literal(3.333_333_333_333_333_5),
        t780).add_product(t22, t777);
    let plate_omega_dot_by_cylinder_v_y = (t19 * t781).sub_product(t18, t782).sub_product(t18, t780)
        .add_product(t19, t779).add_product(t20, t774).sub_product(t21, t773);
    let plate_v_y_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t779)
        .sub_product(R::literal(0.833_333_333_333_333_4), t781)
        .add_product(R::literal(0.833_333_333_333_333_4), t773);
    let plate_v_x_dot_by_cylinder_v_y = (R::literal(0.833_333_333_333_333_4) * t780)
        .sub_product(R::literal(0.833_333_333_333_333_4), t782)
        .add_product(R::literal(0.833_333_333_333_333_4), t774);
    let post_omega_dot_by_cylinder_v_y = (-(t16 * t783).add_product(t15, t784).add_product(t15,
        t782)).add_product(t16, t781).sub_product(t17, t771);
    let post_v_y_dot_by_cylinder_v_y = (R::literal(1.25) * t781).add_product(R::literal(1.25),
        t783);
    let post_v_x_dot_by_cylinder_v_y = (R::literal(1.25) * t782).sub_product(R::literal(1.25),
        t784);
    let t785 = R::literal(50.0) * t387;
    let t786 = R::literal(0.12) * cylinder_omega;
    let t787 = R::literal(3.333_333_333_333_333_5) * t711;
    let t788 = (-t787.add_product(t786, cos_cylinder_phi)).add_product(t24, t785);
    let t789 = R::literal(3.333_333_333_333_333_5) * t750;
    let t790 = (-t789.add_product(t786, sin_cylinder_phi).add_product(t25, t785)).add_product(t85,
        t788);
    let t791 = R::literal(138_888.888_888_888_9) * t387;
    let t792 = (-t791).add_product(t86, t788).sub_product(t97, t790);
    let t793 = (-(t22 * t711)).add_product(R::literal(2.0), ((t188 + t189).add_product(rod_v_x,
        cos_cylinder_phi).add_product(rod_v_y, sin_cylinder_phi) - t184 - t185)
        .sub_product(cylinder_v_x, cos_cylinder_phi).sub_product(cylinder_v_y, sin_cylinder_phi))
        .add_product(t23, t750).sub_product(t26, t785).sub_product(t27, t711).add_product(t28, t750)
        .add_product(t88, t788).sub_product(t99, t790).sub_product(t108, t792);
    let t794 = R::literal(5.0) * t711;
    let t795 = t794.sub_product(t109, t792).sub_product(t119, t793);
    let t796 = R::literal(5.0) * t750;
    let t797 = t796.add_product(t110, t792).sub_product(t121, t793).add_product(t130, t795);
    let t798 = (t90 * t788).sub_product(t101, t790).sub_product(t112, t792).sub_product(t123, t793)
        .sub_product(t132, t795).sub_product(t139, t797);
    let t799 = (t92 * t788).sub_product(t103, t790).sub_product(t114, t792).sub_product(t125, t793)
        .sub_product(t134, t795).sub_product(t141, t797).sub_product(t146, t798);
    let t800 = (t147 * t798).sub_product(t152, t799);
    let t801 = (t94 * t788).sub_product(t105, t790).sub_product(t116, t792).sub_product(t127, t793)
        .sub_product(t136, t795).sub_product(t143, t797).sub_product(t149, t798).sub_product(t154,
        t799).sub_product(t159, t800) * t160;
    let t802 = (t800 * t157).sub_product(t159, t801);
    let t803 = (t799 * t150).sub_product(t152, t802).sub_product(t154, t801);
    let t804 = (t798 * t144).sub_product(t146, t803).add_product(t147, t802).sub_product(t149,
        t801);
    let t805 = (t797 * t137).sub_product(t139, t804).sub_product(t141, t803).sub_product(t143,
        t801);
    let t806 = (-(t795 * t128)).add_product(t130, t805).sub_product(t132, t804).sub_product(t134,
        t803).sub_product(t136, t801);
    let t807 = (t793 * t117).sub_product(t119, t806).sub_product(t121, t805).sub_product(t123, t804)
        .sub_product(t125, t803).sub_product(t127, t801);
    let t808 = (t792 * t106).sub_product(t108, t807).sub_product(t109, t806).add_product(t110, t805)
        .sub_product(t112, t804).sub_product(t114, t803).sub_product(t116, t801);
    let t809 = (t790 * t95).sub_product(t97, t808).sub_product(t99, t807).sub_product(t101, t804)
        .sub_product(t103, t803).sub_product(t105, t801);
    let t810 = (-(t788 * t83)).add_product(t85, t809).add_product(t86, t808).add_product(t88, t807)
        .add_product(t90, t804).add_product(t92, t803).add_product(t94, t801);
    let t811 = (-(t74 * t809).add_product(t72, t810)).add_product(t77, t804).sub_product(t80, t803)
        .sub_product(t82, t801);
    let t812 = (-(t60 * t810).add_product(t58, t811).add_product(t61, t809).add_product(t64, t804))
        .add_product(t66, t803).add_product(t68, t801);
    let t813 = (t51 * t811).add_product(t49, t812).add_product(t53, t801);
    let t814 = (t41 * t812).sub_product(t39, t813).add_product(t39, t811).sub_product(t43, t801);
    let drum_v_y_dot_by_cylinder_omega = (t34 * t802)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t802);
    let drum_v_x_dot_by_cylinder_omega = (t33 * t802)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t802);
    let bobbin_v_y_dot_by_cylinder_omega = -(t32 * t802).add_product(c.inverse_bobbin_mass, t803);
    let bobbin_v_x_dot_by_cylinder_omega = -(t31 * t802).add_product(c.inverse_bobbin_mass, t804);
    let rod_omega_dot_by_cylinder_omega = (t29 * t806)
        .sub_product(R::literal(4_166.666_666_666_667), t808).sub_product(t30, t805);
    let rod_v_y_dot_by_cylinder_omega = -t796.add_product(t28, t807).add_product(R::literal(5.0),
        t805);
    let rod_v_x_dot_by_cylinder_omega = (-t794).add_product(t27, t807).sub_product(R::literal(5.0),
        t806);
    let cylinder_omega_dot_by_cylinder_omega = (-t791.add_product(t24, t810)).add_product(t25, t809)
        .add_product(R::literal(2_777.777_777_777_778), t808).add_product(t26, t807);
    let cylinder_v_y_dot_by_cylinder_omega = t789.sub_product(R::literal(3.333_333_333_333_333_5),
        t809).add_product(t23, t807);
    let cylinder_v_x_dot_by_cylinder_omega = t787.sub_product(R::literal(3.333_333_333_333_333_5),
        t810).sub_product(t22, t807);
    let plate_omega_dot_by_cylinder_omega = (t19 * t811).sub_product(t18, t812).sub_product(t18,
        t810).add_product(t19, t809).add_product(t20, t804).sub_product(t21, t803);
    let plate_v_y_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t809)
        .sub_product(R::literal(0.833_333_333_333_333_4), t811)
        .add_product(R::literal(0.833_333_333_333_333_4), t803);
    let plate_v_x_dot_by_cylinder_omega = (R::literal(0.833_333_333_333_333_4) * t810)
        .sub_product(R::literal(0.833_333_333_333_333_4), t812)
        .add_product(R::literal(0.833_333_333_333_333_4), t804);
    let post_omega_dot_by_cylinder_omega = (-(t16 * t813).add_product(t15, t814).add_product(t15,
        t812)).add_product(t16, t811).sub_product(t17, t801);
    let post_v_y_dot_by_cylinder_omega = (R::literal(1.25) * t811).add_product(R::literal(1.25),
        t813);
    let post_v_x_dot_by_cylinder_omega = (R::literal(1.25) * t812).sub_product(R::literal(1.25),
        t814);
    let t815 = t715 - t714;
    let t816 = (-t718).add_product(t85, t815);
    let t817 = (-t720).add_product(t86, t815).sub_product(t97, t816);
    let t818 = (t713 - t722 + t723 - t724 - t725 + t726).add_product(t88, t815).sub_product(t99,
        t816).sub_product(t108, t817);
    let t819 = t728.sub_product(t109, t817).sub_product(t119, t818);
    let t820 = t730.add_product(t110, t817).sub_product(t121, t818).add_product(t130, t819);
    let t821 = (t90 * t815).sub_product(t101, t816).sub_product(t112, t817).sub_product(t123, t818)
        .sub_product(t132, t819).sub_product(t139, t820);
    let t822 = (t92 * t815).sub_product(t103, t816).sub_product(t114, t817).sub_product(t125, t818)
        .sub_product(t134, t819).sub_product(t141, t820).sub_product(t146, t821);
    let t823 = (t147 * t821).sub_product(t152, t822);
    let t824 = (t94 * t815).sub_product(t105, t816).sub_product(t116, t817).sub_product(t127, t818)
        .sub_product(t136, t819).sub_product(t143, t820).sub_product(t149, t821).sub_product(t154,
        t822).sub_product(t159, t823) * t160;
    let t825 = (t823 * t157).sub_product(t159, t824);
    let t826 = (t822 * t150).sub_product(t152, t825).sub_product(t154, t824);
    let t827 = (t821 * t144).sub_product(t146, t826).add_product(t147, t825).sub_product(t149,
        t824);
    let t828 = (t820 * t137).sub_product(t139, t827).sub_product(t141, t826).sub_product(t143,
        t824);
    let t829 = (-(t819 * t128)).add_product(t130, t828).sub_product(t132, t827).sub_product(t134,
        t826).sub_product(t136, t824);
    let t830 = (t818 * t117).sub_product(t119, t829).sub_product(t121, t828).sub_product(t123, t827)
        .sub_product(t125, t826).sub_product(t127, t824);
    let t831 = (t817 * t106).sub_product(t108, t830).sub_product(t109, t829).add_product(t110, t828)
        .sub_product(t112, t827).sub_product(t114, t826).sub_product(t116, t824);
    let t832 = (t816 * t95).sub_product(t97, t831).sub_product(t99, t830).sub_product(t101, t827)
        .sub_product(t103, t826).sub_product(t105, t824);
    let t833 = (-(t815 * t83)).add_product(t85, t832).add_product(t86, t831).add_product(t88, t830)
        .add_product(t90, t827).add_product(t92, t826).add_product(t94, t824);
    let t834 = (-(t74 * t832).add_product(t72, t833)).add_product(t77, t827).sub_product(t80, t826)
        .sub_product(t82, t824);
    let t835 = (-(t60 * t833).add_product(t58, t834).add_product(t61, t832).add_product(t64, t827))
        .add_product(t66, t826).add_product(t68, t824);
    let t836 = (t51 * t834).add_product(t49, t835).add_product(t53, t824);
    let t837 = (t41 * t835).sub_product(t39, t836).add_product(t39, t834).sub_product(t43, t824);
    let drum_v_y_dot_by_rod_v_x = (t34 * t825).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t825);
    let drum_v_x_dot_by_rod_v_x = (t33 * t825).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t825);
    let bobbin_v_y_dot_by_rod_v_x = -(t32 * t825).add_product(c.inverse_bobbin_mass, t826);
    let bobbin_v_x_dot_by_rod_v_x = -(t31 * t825).add_product(c.inverse_bobbin_mass, t827);
    let rod_omega_dot_by_rod_v_x = (t29 * t829).sub_product(R::literal(4_166.666_666_666_667), t831)
        .sub_product(t30, t828);
    let rod_v_y_dot_by_rod_v_x = -t730.add_product(t28, t830).add_product(R::literal(5.0), t828);
    let rod_v_x_dot_by_rod_v_x = (-t728).add_product(t27, t830).sub_product(R::literal(5.0), t829);
    let cylinder_omega_dot_by_rod_v_x = (-t720.add_product(t24, t833)).add_product(t25, t832)
        .add_product(R::literal(2_777.777_777_777_778), t831).add_product(t26, t830);
    let cylinder_v_y_dot_by_rod_v_x = t717.sub_product(R::literal(3.333_333_333_333_333_5), t832)
        .add_product(t23, t830);
    let cylinder_v_x_dot_by_rod_v_x = t714.sub_product(R::literal(3.333_333_333_333_333_5), t833)
        .sub_product(t22, t830);
    let plate_omega_dot_by_rod_v_x = (t19 * t834).sub_product(t18, t835).sub_product(t18, t833)
        .add_product(t19, t832).add_product(t20, t827).sub_product(t21, t826);
    let plate_v_y_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t832)
        .sub_product(R::literal(0.833_333_333_333_333_4), t834)
        .add_product(R::literal(0.833_333_333_333_333_4), t826);
    let plate_v_x_dot_by_rod_v_x = (R::literal(0.833_333_333_333_333_4) * t833)
        .sub_product(R::literal(0.833_333_333_333_333_4), t835)
        .add_product(R::literal(0.833_333_333_333_333_4), t827);
    let post_omega_dot_by_rod_v_x = (-(t16 * t836).add_product(t15, t837).add_product(t15, t835))
        .add_product(t16, t834).sub_product(t17, t824);
    let post_v_y_dot_by_rod_v_x = (R::literal(1.25) * t834).add_product(R::literal(1.25), t836);
    let post_v_x_dot_by_rod_v_x = (R::literal(1.25) * t835).sub_product(R::literal(1.25), t837);
    let t838 = t752 - t717;
    let t839 = (-t755).add_product(t85, t838);
    let t840 = (-t757).add_product(t86, t838).sub_product(t97, t839);
    let t841 = (t751 - t759 + t760 - t761 - t762 + t763).add_product(t88, t838).sub_product(t99,
        t839).sub_product(t108, t840);
    let t842 = t730.sub_product(t109, t840).sub_product(t119, t841);
    let t843 = t766.add_product(t110, t840).sub_product(t121, t841).add_product(t130, t842);
    let t844 = (t90 * t838).sub_product(t101, t839).sub_product(t112, t840).sub_product(t123, t841)
        .sub_product(t132, t842).sub_product(t139, t843);
    let t845 = (t92 * t838).sub_product(t103, t839).sub_product(t114, t840).sub_product(t125, t841)
        .sub_product(t134, t842).sub_product(t141, t843).sub_product(t146, t844);
    let t846 = (t147 * t844).sub_product(t152, t845);
    let t847 = (t94 * t838).sub_product(t105, t839).sub_product(t116, t840).sub_product(t127, t841)
        .sub_product(t136, t842).sub_product(t143, t843).sub_product(t149, t844).sub_product(t154,
        t845).sub_product(t159, t846) * t160;
    let t848 = (t846 * t157).sub_product(t159, t847);
    let t849 = (t845 * t150).sub_product(t152, t848).sub_product(t154, t847);
    let t850 = (t844 * t144).sub_product(t146, t849).add_product(t147, t848).sub_product(t149,
        t847);
    let t851 = (t843 * t137).sub_product(t139, t850).sub_product(t141, t849).sub_product(t143,
        t847);
    let t852 = (-(t842 * t128)).add_product(t130, t851).sub_product(t132, t850).sub_product(t134,
        t849).sub_product(t136, t847);
    let t853 = (t841 * t117).sub_product(t119, t852).sub_product(t121, t851).sub_product(t123, t850)
        .sub_product(t125, t849).sub_product(t127, t847);
    let t854 = (t840 * t106).sub_product(t108, t853).sub_product(t109, t852).add_product(t110, t851)
        .sub_product(t112, t850).sub_product(t114, t849).sub_product(t116, t847);
    let t855 = (t839 * t95).sub_product(t97, t854).sub_product(t99, t853).sub_product(t101, t850)
        .sub_product(t103, t849).sub_product(t105, t847);
    let t856 = (-(t838 * t83)).add_product(t85, t855).add_product(t86, t854).add_product(t88, t853)
        .add_product(t90, t850).add_product(t92, t849).add_product(t94, t847);
    let t857 = (-(t74 * t855).add_product(t72, t856)).add_product(t77, t850).sub_product(t80, t849)
        .sub_product(t82, t847);
    let t858 = (-(t60 * t856).add_product(t58, t857).add_product(t61, t855).add_product(t64, t850))
        .add_product(t66, t849).add_product(t68, t847);
    let t859 = (t51 * t857).add_product(t49, t858).add_product(t53, t847);
    let t860 = (t41 * t858).sub_product(t39, t859).add_product(t39, t857).sub_product(t43, t847);
    let drum_v_y_dot_by_rod_v_y = (t34 * t848).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t848);
    let drum_v_x_dot_by_rod_v_y = (t33 * t848).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t848);
    let bobbin_v_y_dot_by_rod_v_y = -(t32 * t848).add_product(c.inverse_bobbin_mass, t849);
    let bobbin_v_x_dot_by_rod_v_y = -(t31 * t848).add_product(c.inverse_bobbin_mass, t850);
    let rod_omega_dot_by_rod_v_y = (t29 * t852).sub_product(R::literal(4_166.666_666_666_667), t854)
        .sub_product(t30, t851);
    let rod_v_y_dot_by_rod_v_y = -t766.add_product(t28, t853).add_product(R::literal(5.0), t851);
    let rod_v_x_dot_by_rod_v_y = (-t730).add_product(t27, t853).sub_product(R::literal(5.0), t852);
    let cylinder_omega_dot_by_rod_v_y = (-t757.add_product(t24, t856)).add_product(t25, t855)
        .add_product(R::literal(2_777.777_777_777_778), t854).add_product(t26, t853);
    let cylinder_v_y_dot_by_rod_v_y = t754.sub_product(R::literal(3.333_333_333_333_333_5), t855)
        .add_product(t23, t853);
    let cylinder_v_x_dot_by_rod_v_y = t717.sub_product(R::literal(3.333_333_333_333_333_5), t856)
        .sub_product(t22, t853);
    let plate_omega_dot_by_rod_v_y = (t19 * t857).sub_product(t18, t858).sub_product(t18, t856)
        .add_product(t19, t855).add_product(t20, t850).sub_product(t21, t849);
    let plate_v_y_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t855)
        .sub_product(R::literal(0.833_333_333_333_333_4), t857)
        .add_product(R::literal(0.833_333_333_333_333_4), t849);
    let plate_v_x_dot_by_rod_v_y = (R::literal(0.833_333_333_333_333_4) * t856)
        .sub_product(R::literal(0.833_333_333_333_333_4), t858)
        .add_product(R::literal(0.833_333_333_333_333_4), t850);
    let post_omega_dot_by_rod_v_y = (-(t16 * t859).add_product(t15, t860).add_product(t15, t858))
        .add_product(t16, t857).sub_product(t17, t847);
    let post_v_y_dot_by_rod_v_y = (R::literal(1.25) * t857).add_product(R::literal(1.25), t859);
    let post_v_x_dot_by_rod_v_y = (R::literal(1.25) * t858).sub_product(R::literal(1.25), t860);
    let t861 = R::literal(0.12) * rod_omega;
    let t862 = t861 * cos_rod_phi;
    let t863 = (t861 * sin_rod_phi).add_product(t130, t862);
    let t864 = (t132 * t862).add_product(t139, t863);
    let t865 = (-(t134 * t862).add_product(t141, t863)).add_product(t146, t864);
    let t866 = (t147 * t864).add_product(t152, t865);
    let t867 = (-(t136 * t862).add_product(t143, t863)).add_product(t149, t864).sub_product(t154,
        t865).add_product(t159, t866) * t160;
    let t868 = (t866 * t157).add_product(t159, t867);
    let t869 = (t865 * t150).add_product(t152, t868).sub_product(t154, t867);
    let t870 = (t864 * t144).add_product(t146, t869).add_product(t147, t868).add_product(t149,
        t867);
    let t871 = (t863 * t137).add_product(t139, t870).sub_product(t141, t869).sub_product(t143,
        t867);
    let t872 = (-(t862 * t128)).add_product(t130, t871).add_product(t132, t870).sub_product(t134,
        t869).sub_product(t136, t867);
    let t873 = (-(t121 * t871).add_product(t119, t872)).add_product(t123, t870).sub_product(t125,
        t869).sub_product(t127, t867);
    let t874 = (-(t109 * t872).add_product(t108, t873)).add_product(t110, t871).add_product(t112,
        t870).sub_product(t114, t869).sub_product(t116, t867);
    let t875 = (-(t99 * t873).add_product(t97, t874)).add_product(t101, t870).sub_product(t103,
        t869).sub_product(t105, t867);
    let t876 = (t86 * t874).add_product(t85, t875).add_product(t88, t873).sub_product(t90, t870)
        .add_product(t92, t869).add_product(t94, t867);
    let t877 = (t74 * t875).add_product(t72, t876).add_product(t77, t870).add_product(t80, t869)
        .add_product(t82, t867);
    let t878 = (-(t60 * t876)).add_product(t58, t877).sub_product(t61, t875).add_product(t64, t870)
        .add_product(t66, t869).add_product(t68, t867);
    let t879 = (t51 * t877).sub_product(t49, t878).sub_product(t53, t867);
    let t880 = (t41 * t878).add_product(t39, t879).sub_product(t39, t877).sub_product(t43, t867);
    let drum_v_y_dot_by_rod_omega = (-(t34 * t868))
        .add_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t868);
    let drum_v_x_dot_by_rod_omega = (-(t33 * t868))
        .add_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t868);
    let bobbin_v_y_dot_by_rod_omega = (t32 * t868).sub_product(c.inverse_bobbin_mass, t869);
    let bobbin_v_x_dot_by_rod_omega = (t31 * t868).add_product(c.inverse_bobbin_mass, t870);
    let rod_omega_dot_by_rod_omega = (t29 * t872).sub_product(R::literal(4_166.666_666_666_667),
        t874).sub_product(t30, t871);
    let rod_v_y_dot_by_rod_omega = -(R::literal(5.0) * t871).add_product(t28, t873);
    let rod_v_x_dot_by_rod_omega = (R::literal(-5.0) * t872).add_product(t27, t873);
    let cylinder_omega_dot_by_rod_omega = (t25 * t875).sub_product(t24, t876)
        .add_product(R::literal(2_777.777_777_777_778), t874).add_product(t26, t873);
    let cylinder_v_y_dot_by_rod_omega = (t23 * t873)
        .sub_product(R::literal(3.333_333_333_333_333_5), t875);
    let cylinder_v_x_dot_by_rod_omega = -(t22 * t873)
        .add_product(R::literal(3.333_333_333_333_333_5), t876);
    let plate_omega_dot_by_rod_omega = (-(t19 * t877).add_product(t18, t878).add_product(t18, t876))
        .add_product(t19, t875).sub_product(t20, t870).sub_product(t21, t869);
    let plate_v_y_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t875)
        .add_product(R::literal(0.833_333_333_333_333_4), t877)
        .add_product(R::literal(0.833_333_333_333_333_4), t869);
    let plate_v_x_dot_by_rod_omega = (R::literal(0.833_333_333_333_333_4) * t876)
        .sub_product(R::literal(0.833_333_333_333_333_4), t878)
        .sub_product(R::literal(0.833_333_333_333_333_4), t870);
    let post_omega_dot_by_rod_omega = (t16 * t879).sub_product(t15, t880).sub_product(t15, t878)
        .sub_product(t16, t877).sub_product(t17, t867);
    let post_v_y_dot_by_rod_omega = -(R::literal(1.25) * t877).add_product(R::literal(1.25), t879);
    let post_v_x_dot_by_rod_omega = (R::literal(1.25) * t878).sub_product(R::literal(1.25), t880);
    let t881 = R::literal(2.0) * bobbin_x * drum_x;
    let bobbin_x_times_bobbin_y = bobbin_x * bobbin_y;
    let bobbin_x_times_drum_y = bobbin_x * drum_y;
    let bobbin_y_times_drum_x = bobbin_y * drum_x;
    let drum_x_times_drum_y = drum_x * drum_y;
    let bobbin_x_squared = bobbin_x * bobbin_x;
    let drum_x_squared = drum_x * drum_x;
    let t882 = R::literal(2.0) * (bobbin_x_times_bobbin_y * bobbin_v_y).add_product(t881, drum_v_x)
        .add_product(bobbin_x_times_drum_y, drum_v_y).add_product(bobbin_y_times_drum_x, drum_v_y)
        .add_product(drum_x_times_drum_y, bobbin_v_y).add_product(bobbin_v_x, bobbin_x_squared)
        .add_product(bobbin_v_x, drum_x_squared).add_product(drum_v_x, between_squared)
        .sub_product(t881, bobbin_v_x).sub_product(bobbin_x_times_bobbin_y, drum_v_y)
        .sub_product(bobbin_x_times_drum_y, bobbin_v_y).sub_product(bobbin_y_times_drum_x,
        bobbin_v_y).sub_product(drum_x_times_drum_y, drum_v_y).sub_product(bobbin_v_x,
        between_squared).sub_product(drum_v_x, bobbin_x_squared).sub_product(drum_v_x,
        drum_x_squared) / between_squared_times_between;
    let t883 = t159 * t882 * t160;
    let t884 = (t882 * t157).add_product(t159, t883);
    let t885 = t152 * t884;
    let t886 = t154 * t883;
    let t887 = t886 - t885;
    let t888 = t147 * t884;
    let t889 = t149 * t883;
    let t890 = t888.sub_product(t146, t887) + t889;
    let t891 = t143 * t883;
    let t892 = t891 - (t141 * t887).add_product(t139, t890);
    let t893 = t136 * t883;
    let t894 = (-(t132 * t890)).add_product(t130, t892).sub_product(t134, t887) + t893;
    let t895 = t127 * t883;
    let t896 = t895 - (t121 * t892).add_product(t119, t894).add_product(t123, t890)
        .add_product(t125, t887);
    let t897 = t116 * t883;
    let t898 = (-(t109 * t894).add_product(t108, t896)).add_product(t110, t892).sub_product(t112,
        t890).sub_product(t114, t887) + t897;
    let t899 = t105 * t883;
    let t900 = t899 - (t99 * t896).add_product(t97, t898).add_product(t101, t890).add_product(t103,
        t887);
    let t901 = t94 * t883;
    let t902 = (t86 * t898).add_product(t85, t900).add_product(t88, t896).add_product(t90, t890)
        .add_product(t92, t887) - t901;
    let t903 = t82 * t883;
    let t904 = (-(t74 * t900).add_product(t72, t902)).add_product(t77, t890).sub_product(t80, t887)
        + t903;
    let t905 = t68 * t883;
    let t906 = (-(t60 * t902).add_product(t58, t904).add_product(t61, t900).add_product(t64, t890))
        .add_product(t66, t887) - t905;
    let t907 = t53 * t883;
    let t908 = t907 - (t51 * t904).add_product(t49, t906);
    let t909 = t43 * t883;
    let t910 = (t41 * t906).add_product(t39, t908).add_product(t39, t904) + t909;
    let t911 = R::literal(0.666_666_666_666_666_6) * (bobbin_y_minus_drum_y_over_between * t884);
    let t912 = t34 * t884;
    let drum_v_y_dot_by_bobbin_v_x = t912 - t911;
    let t913 = R::literal(0.666_666_666_666_666_6) * (bobbin_x_minus_drum_x_over_between * t884);
    let t914 = t33 * t884;
    let drum_v_x_dot_by_bobbin_v_x = t914 - t913;
    let t915 = t32 * t884;
    let bobbin_v_y_dot_by_bobbin_v_x = -t915.add_product(c.inverse_bobbin_mass, t887);
    let t916 = t31 * t884;
    let bobbin_v_x_dot_by_bobbin_v_x = -t916.add_product(c.inverse_bobbin_mass, t890);
    let rod_omega_dot_by_bobbin_v_x = (t29 * t894).sub_product(R::literal(4_166.666_666_666_667),
        t898).sub_product(t30, t892);
    let rod_v_y_dot_by_bobbin_v_x = -(R::literal(5.0) * t892).add_product(t28, t896);
    let rod_v_x_dot_by_bobbin_v_x = (R::literal(-5.0) * t894).add_product(t27, t896);
    let cylinder_omega_dot_by_bobbin_v_x = (t25 * t900).sub_product(t24, t902)
        .add_product(R::literal(2_777.777_777_777_778), t898).add_product(t26, t896);
    let cylinder_v_y_dot_by_bobbin_v_x = (t23 * t896)
        .sub_product(R::literal(3.333_333_333_333_333_5), t900);
    let cylinder_v_x_dot_by_bobbin_v_x = -(t22 * t896)
        .add_product(R::literal(3.333_333_333_333_333_5), t902);
    let plate_omega_dot_by_bobbin_v_x = (t19 * t904).sub_product(t18, t906).sub_product(t18, t902)
        .add_product(t19, t900).add_product(t20, t890).sub_product(t21, t887);
    let plate_v_y_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t900)
        .sub_product(R::literal(0.833_333_333_333_333_4), t904)
        .add_product(R::literal(0.833_333_333_333_333_4), t887);
    let plate_v_x_dot_by_bobbin_v_x = (R::literal(0.833_333_333_333_333_4) * t902)
        .sub_product(R::literal(0.833_333_333_333_333_4), t906)
        .add_product(R::literal(0.833_333_333_333_333_4), t890);
    let t917 = t17 * t883;
    let post_omega_dot_by_bobbin_v_x = (t16 * t908).sub_product(t15, t910).sub_product(t15, t906)
        .add_product(t16, t904) + t917;
    let post_v_y_dot_by_bobbin_v_x = (R::literal(1.25) * t904).sub_product(R::literal(1.25), t908);
    let post_v_x_dot_by_bobbin_v_x = (R::literal(1.25) * t906).sub_product(R::literal(1.25), t910);
    let t918 = R::literal(2.0) * bobbin_y * drum_y;
    let bobbin_y_squared = bobbin_y * bobbin_y;
    let drum_y_squared = drum_y * drum_y;
    let t919 = R::literal(2.0) * (bobbin_x_times_bobbin_y * bobbin_v_x).add_product(t918, drum_v_y)
        .add_product(bobbin_x_times_drum_y, drum_v_x).add_product(bobbin_y_times_drum_x, drum_v_x)
        .add_product(drum_x_times_drum_y, bobbin_v_x).add_product(bobbin_v_y, bobbin_y_squared)
        .add_product(bobbin_v_y, drum_y_squared).add_product(drum_v_y, between_squared)
        .sub_product(t918, bobbin_v_y).sub_product(bobbin_x_times_bobbin_y, drum_v_x)
        .sub_product(bobbin_x_times_drum_y, bobbin_v_x).sub_product(bobbin_y_times_drum_x,
        bobbin_v_x).sub_product(drum_x_times_drum_y, drum_v_x).sub_product(bobbin_v_y,
        between_squared).sub_product(drum_v_y, bobbin_y_squared).sub_product(drum_v_y,
        drum_y_squared) / between_squared_times_between;
    let t920 = t159 * t919 * t160;
    let t921 = (t919 * t157).add_product(t159, t920);
    let t922 = t152 * t921;
    let t923 = t154 * t920;
    let t924 = t923 - t922;
    let t925 = t147 * t921;
    let t926 = t149 * t920;
    let t927 = t925.sub_product(t146, t924) + t926;
    let t928 = t143 * t920;
    let t929 = t928 - (t141 * t924).add_product(t139, t927);
    let t930 = t136 * t920;
    let t931 = (-(t132 * t927)).add_product(t130, t929).sub_product(t134, t924) + t930;
    let t932 = t127 * t920;
    let t933 = t932 - (t121 * t929).add_product(t119, t931).add_product(t123, t927)
        .add_product(t125, t924);
    let t934 = t116 * t920;
    let t935 = (-(t109 * t931).add_product(t108, t933)).add_product(t110, t929).sub_product(t112,
        t927).sub_product(t114, t924) + t934;
    let t936 = t105 * t920;
    let t937 = t936 - (t99 * t933).add_product(t97, t935).add_product(t101, t927).add_product(t103,
        t924);
    let t938 = t94 * t920;
    let t939 = (t86 * t935).add_product(t85, t937).add_product(t88, t933).add_product(t90, t927)
        .add_product(t92, t924) - t938;
    let t940 = t82 * t920;
    let t941 = (-(t74 * t937).add_product(t72, t939)).add_product(t77, t927).sub_product(t80, t924)
        + t940;
    let t942 = t68 * t920;
    let t943 = (-(t60 * t939).add_product(t58, t941).add_product(t61, t937).add_product(t64, t927))
        .add_product(t66, t924) - t942;
    let t944 = t53 * t920;
    let t945 = t944 - (t51 * t941).add_product(t49, t943);
    let t946 = t43 * t920;
    let t947 = (t41 * t943).add_product(t39, t945).add_product(t39, t941) + t946;
    let t948 = R::literal(0.666_666_666_666_666_6) * (bobbin_y_minus_drum_y_over_between * t921);
    let t949 = t34 * t921;
    let drum_v_y_dot_by_bobbin_v_y = t949 - t948;
    let t950 = R::literal(0.666_666_666_666_666_6) * (bobbin_x_minus_drum_x_over_between * t921);
    let t951 = t33 * t921;
    let drum_v_x_dot_by_bobbin_v_y = t951 - t950;
    let t952 = t32 * t921;
    let bobbin_v_y_dot_by_bobbin_v_y = -t952.add_product(c.inverse_bobbin_mass, t924);
    let t953 = t31 * t921;
    let bobbin_v_x_dot_by_bobbin_v_y = -t953.add_product(c.inverse_bobbin_mass, t927);
    let rod_omega_dot_by_bobbin_v_y = (t29 * t931).sub_product(R::literal(4_166.666_666_666_667),
        t935).sub_product(t30, t929);
    let rod_v_y_dot_by_bobbin_v_y = -(R::literal(5.0) * t929).add_product(t28, t933);
    let rod_v_x_dot_by_bobbin_v_y = (R::literal(-5.0) * t931).add_product(t27, t933);
    let cylinder_omega_dot_by_bobbin_v_y = (t25 * t937).sub_product(t24, t939)
        .add_product(R::literal(2_777.777_777_777_778), t935).add_product(t26, t933);
    let cylinder_v_y_dot_by_bobbin_v_y = (t23 * t933)
        .sub_product(R::literal(3.333_333_333_333_333_5), t937);
    let cylinder_v_x_dot_by_bobbin_v_y = -(t22 * t933)
        .add_product(R::literal(3.333_333_333_333_333_5), t939);
    let plate_omega_dot_by_bobbin_v_y = (t19 * t941).sub_product(t18, t943).sub_product(t18, t939)
        .add_product(t19, t937).add_product(t20, t927).sub_product(t21, t924);
    let plate_v_y_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t937)
        .sub_product(R::literal(0.833_333_333_333_333_4), t941)
        .add_product(R::literal(0.833_333_333_333_333_4), t924);
    let plate_v_x_dot_by_bobbin_v_y = (R::literal(0.833_333_333_333_333_4) * t939)
        .sub_product(R::literal(0.833_333_333_333_333_4), t943)
        .add_product(R::literal(0.833_333_333_333_333_4), t927);
    let t954 = t17 * t920;
    let post_omega_dot_by_bobbin_v_y = (t16 * t945).sub_product(t15, t947).sub_product(t15, t943)
        .add_product(t16, t941) + t954;
    let post_v_y_dot_by_bobbin_v_y = (R::literal(1.25) * t941).sub_product(R::literal(1.25), t945);
    let post_v_x_dot_by_bobbin_v_y = (R::literal(1.25) * t943).sub_product(R::literal(1.25), t947);
    let t955 = t885 - t886;
    let t956 = t888.add_product(t146, t955) + t889;
    let t957 = (-(t141 * t955)).add_product(t139, t956) - t891;
    let t958 = (t132 * t956).add_product(t130, t957).sub_product(t134, t955) - t893;
    let t959 = (-(t121 * t957).add_product(t119, t958)).add_product(t123, t956).sub_product(t125,
        t955) - t895;
    let t960 = (-(t109 * t958).add_product(t108, t959)).add_product(t110, t957).add_product(t112,
        t956).sub_product(t114, t955) - t897;
    let t961 = (-(t99 * t959).add_product(t97, t960)).add_product(t101, t956).sub_product(t103,
        t955) - t899;
    let t962 = (t86 * t960).add_product(t85, t961).add_product(t88, t959).sub_product(t90, t956)
        .add_product(t92, t955) + t901;
    let t963 = (t74 * t961).add_product(t72, t962).add_product(t77, t956).add_product(t80, t955)
        + t903;
    let t964 = (-(t60 * t962)).add_product(t58, t963).sub_product(t61, t961).add_product(t64, t956)
        .add_product(t66, t955) + t905;
    let t965 = (t51 * t963).sub_product(t49, t964) - t907;
    let t966 = (t41 * t964).add_product(t39, t965).sub_product(t39, t963) - t909;
    let drum_v_y_dot_by_drum_v_x = t911 - t912;
    let drum_v_x_dot_by_drum_v_x = t913 - t914;
    let bobbin_v_y_dot_by_drum_v_x = t915.sub_product(c.inverse_bobbin_mass, t955);
    let bobbin_v_x_dot_by_drum_v_x = t916.add_product(c.inverse_bobbin_mass, t956);
    let rod_omega_dot_by_drum_v_x = (t29 * t958).sub_product(R::literal(4_166.666_666_666_667),
        t960).sub_product(t30, t957);
    let rod_v_y_dot_by_drum_v_x = -(R::literal(5.0) * t957).add_product(t28, t959);
    let rod_v_x_dot_by_drum_v_x = (R::literal(-5.0) * t958).add_product(t27, t959);
    let cylinder_omega_dot_by_drum_v_x = (t25 * t961).sub_product(t24, t962)
        .add_product(R::literal(2_777.777_777_777_778), t960).add_product(t26, t959);
    let cylinder_v_y_dot_by_drum_v_x = (t23 * t959)
        .sub_product(R::literal(3.333_333_333_333_333_5), t961);
    let cylinder_v_x_dot_by_drum_v_x = -(t22 * t959)
        .add_product(R::literal(3.333_333_333_333_333_5), t962);
    let plate_omega_dot_by_drum_v_x = (-(t19 * t963).add_product(t18, t964).add_product(t18, t962))
        .add_product(t19, t961).sub_product(t20, t956).sub_product(t21, t955);
    let plate_v_y_dot_by_drum_v_x = (R::literal(0.833_333_333_333_333_4) * t961)
        .add_product(R::literal(0.833_333_333_333_333_4), t963)
        .add_product(R::literal(0.833_333_333_333_333_4), t955);
    let plate_v_x_dot_by_drum_v_x = (R::literal(0.833_333_333_333_333_4) * t962)
        .sub_product(R::literal(0.833_333_333_333_333_4), t964)
        .sub_product(R::literal(0.833_333_333_333_333_4), t956);
    let post_omega_dot_by_drum_v_x = (t16 * t965).sub_product(t15, t966).sub_product(t15, t964)
        .sub_product(t16, t963) - t917;
    let post_v_y_dot_by_drum_v_x = -(R::literal(1.25) * t963).add_product(R::literal(1.25), t965);
    let post_v_x_dot_by_drum_v_x = (R::literal(1.25) * t964).sub_product(R::literal(1.25), t966);
    let t967 = t922 - t923;
    let t968 = t925.add_product(t146, t967) + t926;
    let t969 = (-(t141 * t967)).add_product(t139, t968) - t928;
    let t970 = (t132 * t968).add_product(t130, t969).sub_product(t134, t967) - t930;
    let t971 = (-(t121 * t969).add_product(t119, t970)).add_product(t123, t968).sub_product(t125,
        t967) - t932;
    let t972 = (-(t109 * t970).add_product(t108, t971)).add_product(t110, t969).add_product(t112,
        t968).sub_product(t114, t967) - t934;
    let t973 = (-(t99 * t971).add_product(t97, t972)).add_product(t101, t968).sub_product(t103,
        t967) - t936;
    let t974 = (t86 * t972).add_product(t85, t973).add_product(t88, t971).sub_product(t90, t968)
        .add_product(t92, t967) + t938;
    let t975 = (t74 * t973).add_product(t72, t974).add_product(t77, t968).add_product(t80, t967)
        + t940;
    let t976 = (-(t60 * t974)).add_product(t58, t975).sub_product(t61, t973).add_product(t64, t968)
        .add_product(t66, t967) + t942;
    let t977 = (t51 * t975).sub_product(t49, t976) - t944;
    let t978 = (t41 * t976).add_product(t39, t977).sub_product(t39, t975) - t946;
    let drum_v_y_dot_by_drum_v_y = t948 - t949;
    let drum_v_x_dot_by_drum_v_y = t950 - t951;
    let bobbin_v_y_dot_by_drum_v_y = t952.sub_product(c.inverse_bobbin_mass, t967);
    let bobbin_v_x_dot_by_drum_v_y = t953.add_product(c.inverse_bobbin_mass, t968);
    let rod_omega_dot_by_drum_v_y = (t29 * t970).sub_product(R::literal(4_166.666_666_666_667),
        t972).sub_product(t30, t969);
    let rod_v_y_dot_by_drum_v_y = -(R::literal(5.0) * t969).add_product(t28, t971);
    let rod_v_x_dot_by_drum_v_y = (R::literal(-5.0) * t970).add_product(t27, t971);
    let cylinder_omega_dot_by_drum_v_y = (t25 * t973).sub_product(t24, t974)
        .add_product(R::literal(2_777.777_777_777_778), t972).add_product(t26, t971);
    let cylinder_v_y_dot_by_drum_v_y = (t23 * t971)
        .sub_product(R::literal(3.333_333_333_333_333_5), t973);
    let cylinder_v_x_dot_by_drum_v_y = -(t22 * t971)
        .add_product(R::literal(3.333_333_333_333_333_5), t974);
    let plate_omega_dot_by_drum_v_y = (-(t19 * t975).add_product(t18, t976).add_product(t18, t974))
        .add_product(t19, t973).sub_product(t20, t968).sub_product(t21, t967);
    let plate_v_y_dot_by_drum_v_y = (R::literal(0.833_333_333_333_333_4) * t973)
        .add_product(R::literal(0.833_333_333_333_333_4), t975)
        .add_product(R::literal(0.833_333_333_333_333_4), t967);
    let plate_v_x_dot_by_drum_v_y = (R::literal(0.833_333_333_333_333_4) * t974)
        .sub_product(R::literal(0.833_333_333_333_333_4), t976)
        .sub_product(R::literal(0.833_333_333_333_333_4), t968);
    let post_omega_dot_by_drum_v_y = (t16 * t977).sub_product(t15, t978).sub_product(t15, t976)
        .sub_product(t16, t975) - t954;
    let post_v_y_dot_by_drum_v_y = -(R::literal(1.25) * t975).add_product(R::literal(1.25), t977);
    let post_v_x_dot_by_drum_v_y = (R::literal(1.25) * t976).sub_product(R::literal(1.25), t978);
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

/// `dy'/dp`, values in the order of its pattern. 2133 operations.
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
    let t9 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t10 = R::literal(0.01) * t9;
    let t11 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t13 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t14 = t8 * R::literal(370.370_370_370_370_3);
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = R::literal(4.0) * t9;
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(1.25) + t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(1.25) + t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t43 - t42);
    let t45 = (t12 * t0).add_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 + t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).sub_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0) / (-(t33 + R::literal(0.833_333_333_333_333_4) + t51))
        .add_product(t38, t37).sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).add_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t39.add_product(t40, t37).add_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0) / (t43 - (t42 + R::literal(0.833_333_333_333_333_4) + t66))
        .sub_product(t48, t47).sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = t17 * t2;
    let t73 = t72.add_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).add_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t51
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t5).add_product(t57, t56)
        .add_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = t21 * t80;
    let t84 = (-t19).add_product(t23, t5);
    let t85 = t84 * t80;
    let t86 = (t59 - R::literal(0.833_333_333_333_333_4)).sub_product(t61, t56).add_product(t74,
        t68);
    let t87 = t86 * t80;
    let t88 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t89 = t88 * t80;
    let t90 = (t65 * t56).sub_product(t79, t68);
    let t91 = t90 * t80;
    let t92 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t66
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t58, t53)
        .add_product(t71, t70)).add_product(t82, t81);
    let t93 = (-t22).add_product(t83, t81);
    let t94 = t93 * t92;
    let t95 = t20.sub_product(t23, t4).add_product(t85, t81);
    let t96 = t95 * t92;
    let t97 = (-t72.add_product(t61, t53)).add_product(t74, t70).add_product(t87, t81);
    let t98 = t97 * t92;
    let t99 = (t75 - R::literal(0.833_333_333_333_333_4)).add_product(t63, t53).sub_product(t77,
        t70).add_product(t89, t81);
    let t100 = t99 * t92;
    let t101 = (t65 * t53).sub_product(t79, t70).add_product(t91, t81);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t83, t21)
        .sub_product(t94, t93);
    let t104 = (-t23).add_product(t85, t21).sub_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t26 * t103;
    let t107 = t27 * t103;
    let t108 = (t87 * t21).sub_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t21).sub_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t21).sub_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t24.sub_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = (-t25).add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (t87 * t84).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (t89 * t84).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (t91 * t84).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t106, t26)
        .add_product(t116, t115);
    let t126 = (t27 * t6).add_product(t107, t26).sub_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (t109 * t26).add_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (t111 * t26).add_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (t113 * t26).add_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t107, t27).add_product(t118, t117)).add_product(t127, t126);
    let t135 = (t109 * t27).sub_product(t120, t117).sub_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (t111 * t27).sub_product(t122, t117).sub_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (t113 * t27).sub_product(t124, t117).sub_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + inverse_bobbin_mass).add_product(t61, t60).add_product(t74, t73)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t18 * t10).add_product(t63, t60).add_product(t77, t73).add_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).add_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t28 * t141;
    let t145 = (t65 * t60).add_product(t79, t73).add_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).add_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t11)
        + inverse_bobbin_mass).add_product(t63, t62).add_product(t77, t76)).add_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).add_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t29).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (-(t65 * t62).add_product(t79, t76)).add_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).add_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t30 * bobbin_x_minus_drum_x_over_between;
    let t153 = t31 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (t152 - ((t28 * bobbin_x_minus_drum_x_over_between)
        .add_product(t29, bobbin_y_minus_drum_y_over_between) + t152 + t153).add_product(t144, t28)
        .add_product(t149, t148) + t153);
    let t155 = (t146 * t28).sub_product(t151, t148);
    let t156 = t155 * t154;
    let t157 = R::literal(1.0) / (-(t14 * t8)).add_product(t40, t39).sub_product(t50, t49)
        .sub_product(t65, t64).sub_product(t79, t78).add_product(t91, t90).sub_product(t102, t101)
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
    let t182 = t36 * t169;
    let t183 = R::literal(9.81) - t170 - t182;
    let t184 = t15 * bobbin_radius_times_winding_force;
    let t185 = (t184 - t169.add_product(t171, cos_plate_phi)).sub_product(t38, t169)
        .sub_product(t46, t183);
    let t186 = t16 * bobbin_radius_times_winding_force;
    let t187 = (R::literal(9.81) - (t170.add_product(t171, sin_plate_phi) + R::literal(9.81))
        - t186 - t182).sub_product(t48, t183).sub_product(t55, t185);
    let t188 = t184.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .sub_product(R::literal(3.333_333_333_333_333_5), t160).add_product(t21, t164)
        .sub_product(t57, t185).sub_product(t69, t187);
    let t189 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t186)
        .add_product(R::literal(3.333_333_333_333_333_5), t163).add_product(t22, t164)
        .add_product(t58, t185).add_product(t71, t187)).add_product(t82, t188);
    let t190 = (R::literal(-2_777.777_777_777_778) * t164).add_product(t83, t188).sub_product(t94,
        t189);
    let t191 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t160)
        .add_product(t20, t163).sub_product(t23, t164).sub_product(t24, t160).add_product(t25, t165)
        .add_product(t85, t188).sub_product(t96, t189);
    let t192 = t191.sub_product(t105, t190);
    let t193 = (t172 * cos_rod_phi).add_product(R::literal(5.0), t160).sub_product(t106, t190)
        .sub_product(t116, t192);
    let t194 = (t172 * sin_rod_phi).add_product(R::literal(5.0), t165).add_product(t107, t190)
        .sub_product(t118, t192).add_product(t127, t193);
    let t195 = inverse_bobbin_mass * t166;
    let t196 = ((t11 * plate_omega_squared).sub_product(t17, bobbin_radius_times_winding_force)
        + t195).sub_product(t61, t185).add_product(t74, t187).add_product(t87, t188)
        .sub_product(t98, t189).sub_product(t109, t190).sub_product(t120, t192).sub_product(t129,
        t193).sub_product(t136, t194);
    let t197 = inverse_bobbin_mass * t167;
    let t198 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared).add_product(t18,
        bobbin_radius_times_winding_force) - t197).add_product(t63, t185).sub_product(t77, t187)
        .add_product(t89, t188).sub_product(t100, t189).sub_product(t111, t190).sub_product(t122,
        t192).sub_product(t131, t193).sub_product(t138, t194).sub_product(t143, t196);
    let t199 = R::literal(9.809_999_999_999_999) * bobbin_y_minus_drum_y_over_between;
    let t200 = ((-t181).add_product(t28, t166).sub_product(t29, t167) - t199).add_product(t144,
        t196).sub_product(t149, t198) + t199;
    let t201 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t40, t169).sub_product(t50, t183).add_product(t65, t185)
        .sub_product(t79, t187).add_product(t91, t188).sub_product(t102, t189).sub_product(t113,
        t190).sub_product(t124, t192).sub_product(t133, t193).sub_product(t140, t194)
        .sub_product(t146, t196).sub_product(t151, t198).sub_product(t156, t200) * t157;
    let t202 = (t200 * t154).sub_product(t156, t201);
    let t203 = (t198 * t147).sub_product(t149, t202).sub_product(t151, t201);
    let bobbin_v_y_dot = t197.sub_product(inverse_bobbin_mass, t203).sub_product(t29, t202);
    let t204 = t195.add_product(inverse_bobbin_mass, (t196 * t141).sub_product(t143, t203)
        .add_product(t144, t202).sub_product(t146, t201)).add_product(t28, t202);
    let t205 = p.spring_stiffness * cos_cylinder_phi;
    let t206 = p.spring_stiffness * t7;
    let t207 = p.spring_stiffness * sin_cylinder_phi;
    let t208 = t15 * p.winding_force;
    let t209 = t16 * p.winding_force;
    let t210 = t209.add_product(t55, t208);
    let t211 = t208.sub_product(t57, t208).add_product(t69, t210);
    let t212 = (-t209.add_product(t58, t208)).add_product(t71, t210).add_product(t82, t211);
    let t213 = (t83 * t211).sub_product(t94, t212);
    let t214 = (t85 * t211).sub_product(t96, t212).sub_product(t105, t213);
    let t215 = (t106 * t213).add_product(t116, t214);
    let t216 = (t107 * t213).sub_product(t118, t214).sub_product(t127, t215);
    let t217 = (-(t17 * p.winding_force).add_product(t61, t208).add_product(t74, t210))
        .add_product(t87, t211).sub_product(t98, t212).sub_product(t109, t213).sub_product(t120,
        t214).add_product(t129, t215).sub_product(t136, t216);
    let t218 = (t18 * p.winding_force).add_product(t63, t208).add_product(t77, t210)
        .add_product(t89, t211).sub_product(t100, t212).sub_product(t111, t213).sub_product(t122,
        t214).add_product(t131, t215).sub_product(t138, t216).sub_product(t143, t217);
    let t219 = (t144 * t217).sub_product(t149, t218);
    let t220 = (t65 * t208).add_product(t79, t210).add_product(t91, t211).sub_product(t102, t212)
        .sub_product(t113, t213).sub_product(t124, t214).add_product(t133, t215).sub_product(t140,
        t216).sub_product(t146, t217).sub_product(t151, t218).sub_product(t156, t219) * t157;
    let t221 = (t219 * t154).sub_product(t156, t220);
    let t222 = (t218 * t147).sub_product(t149, t221).sub_product(t151, t220);
    let t223 = (t217 * t141).sub_product(t143, t222).add_product(t144, t221).sub_product(t146,
        t220);
    let t224 = (t216 * t134).sub_product(t136, t223).sub_product(t138, t222).sub_product(t140,
        t220);
    let t225 = (t215 * t125).add_product(t127, t224).sub_product(t129, t223).sub_product(t131, t222)
        .sub_product(t133, t220);
    let t226 = (t214 * t114).sub_product(t116, t225).sub_product(t118, t224).sub_product(t120, t223)
        .sub_product(t122, t222).sub_product(t124, t220);
    let t227 = (t213 * t103).sub_product(t105, t226).sub_product(t106, t225).add_product(t107, t224)
        .sub_product(t109, t223).sub_product(t111, t222).sub_product(t113, t220);
    let t228 = (t212 * t92).sub_product(t94, t227).sub_product(t96, t226).sub_product(t98, t223)
        .sub_product(t100, t222).sub_product(t102, t220);
    let t229 = (-(t211 * t80)).add_product(t82, t228).add_product(t83, t227).add_product(t85, t226)
        .add_product(t87, t223).add_product(t89, t222).add_product(t91, t220);
    let t230 = (-(t210 * t67).add_product(t69, t229).add_product(t71, t228)).add_product(t74, t223)
        .sub_product(t77, t222).sub_product(t79, t220);
    let t231 = (t208 * t52).sub_product(t55, t230).sub_product(t57, t229).sub_product(t58, t228)
        .sub_product(t61, t223).add_product(t63, t222).add_product(t65, t220);
    let t232 = (t48 * t230).add_product(t46, t231).add_product(t50, t220);
    let t233 = (t38 * t231).sub_product(t36, t232).add_product(t36, t230).sub_product(t40, t220);
    let drum_v_y_dot_by_bobbin_radius = (t31 * t221)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t221);
    let drum_v_x_dot_by_bobbin_radius = (t30 * t221)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t221);
    let bobbin_v_y_dot_by_bobbin_radius = -(t29 * t221).add_product(inverse_bobbin_mass, t222);
    let bobbin_v_x_dot_by_bobbin_radius = -(t28 * t221).add_product(inverse_bobbin_mass, t223);
    let rod_omega_dot_by_bobbin_radius = (t26 * t225)
        .sub_product(R::literal(4_166.666_666_666_667), t227).sub_product(t27, t224);
    let rod_v_y_dot_by_bobbin_radius = -(R::literal(5.0) * t224).add_product(t25, t226);
    let rod_v_x_dot_by_bobbin_radius = (R::literal(-5.0) * t225).add_product(t24, t226);
    let cylinder_omega_dot_by_bobbin_radius = (t22 * t228).sub_product(t21, t229)
        .add_product(R::literal(2_777.777_777_777_778), t227).add_product(t23, t226);
    let cylinder_v_y_dot_by_bobbin_radius = (t20 * t226)
        .sub_product(R::literal(3.333_333_333_333_333_5), t228);
    let cylinder_v_x_dot_by_bobbin_radius = -(t19 * t226)
        .add_product(R::literal(3.333_333_333_333_333_5), t229);
    let plate_omega_dot_by_bobbin_radius = (-(p.winding_force * R::literal(400.0)).add_product(t15,
        t231)).add_product(t16, t230).sub_product(t15, t229).add_product(t16, t228)
        .add_product(t17, t223).sub_product(t18, t222);
    let plate_v_y_dot_by_bobbin_radius = (R::literal(0.833_333_333_333_333_4) * t228)
        .sub_product(R::literal(0.833_333_333_333_333_4), t230)
        .add_product(R::literal(0.833_333_333_333_333_4), t222);
    let plate_v_x_dot_by_bobbin_radius = (R::literal(0.833_333_333_333_333_4) * t229)
        .sub_product(R::literal(0.833_333_333_333_333_4), t231)
        .add_product(R::literal(0.833_333_333_333_333_4), t223);
    let post_omega_dot_by_bobbin_radius = (-(t13 * t232).add_product(t12, t233).add_product(t12,
        t231)).add_product(t13, t230).sub_product(t14, t220);
    let post_v_y_dot_by_bobbin_radius = (R::literal(1.25) * t230).add_product(R::literal(1.25),
        t232);
    let post_v_x_dot_by_bobbin_radius = (R::literal(1.25) * t231).sub_product(R::literal(1.25),
        t233);
    let t234 = t15 * p.bobbin_radius;
    let t235 = t16 * p.bobbin_radius;
    let t236 = t235.add_product(t55, t234);
    let t237 = t234.sub_product(t57, t234).add_product(t69, t236);
    let t238 = (-t235.add_product(t58, t234)).add_product(t71, t236).add_product(t82, t237);
    let t239 = (t83 * t237).sub_product(t94, t238);
    let t240 = (t85 * t237).sub_product(t96, t238).sub_product(t105, t239);
    let t241 = (t106 * t239).add_product(t116, t240);
    let t242 = (t107 * t239).sub_product(t118, t240).sub_product(t127, t241);
    let t243 = t29.sub_product(t17, p.bobbin_radius).sub_product(t61, t234).sub_product(t74, t236)
        .add_product(t87, t237).sub_product(t98, t238).sub_product(t109, t239).sub_product(t120,
        t240).add_product(t129, t241).sub_product(t136, t242);
    let t244 = (-t28).add_product(t18, p.bobbin_radius).add_product(t63, t234).add_product(t77,
        t236).add_product(t89, t237).sub_product(t100, t238).sub_product(t111, t239)
        .sub_product(t122, t240).add_product(t131, t241).sub_product(t138, t242).sub_product(t143,
        t243);
    let t245 = (t28 * bobbin_y_minus_drum_y_over_between).sub_product(t29,
        bobbin_x_minus_drum_x_over_between).add_product(t144, t243).sub_product(t149, t244);
    let t246 = (t65 * t234).add_product(t79, t236).add_product(t91, t237).sub_product(t102, t238)
        .sub_product(t113, t239).sub_product(t124, t240).add_product(t133, t241).sub_product(t140,
        t242).sub_product(t146, t243).sub_product(t151, t244).sub_product(t156, t245) * t157;
    let t247 = (t245 * t154).sub_product(t156, t246);
    let t248 = (t244 * t147).sub_product(t149, t247).sub_product(t151, t246);
    let t249 = (t243 * t141).sub_product(t143, t248).add_product(t144, t247).sub_product(t146,
        t246);
    let t250 = (t242 * t134).sub_product(t136, t249).sub_product(t138, t248).sub_product(t140,
        t246);
    let t251 = (t241 * t125).add_product(t127, t250).sub_product(t129, t249).sub_product(t131, t248)
        .sub_product(t133, t246);
    let t252 = (t240 * t114).sub_product(t116, t251).sub_product(t118, t250).sub_product(t120, t249)
        .sub_product(t122, t248).sub_product(t124, t246);
    let t253 = (t239 * t103).sub_product(t105, t252).sub_product(t106, t251).add_product(t107, t250)
        .sub_product(t109, t249).sub_product(t111, t248).sub_product(t113, t246);
    let t254 = (t238 * t92).sub_product(t94, t253).sub_product(t96, t252).sub_product(t98, t249)
        .sub_product(t100, t248).sub_product(t102, t246);
    let t255 = (-(t237 * t80)).add_product(t82, t254).add_product(t83, t253).add_product(t85, t252)
        .add_product(t87, t249).add_product(t89, t248).add_product(t91, t246);
    let t256 = (-(t236 * t67).add_product(t69, t255).add_product(t71, t254)).add_product(t74, t249)
        .sub_product(t77, t248).sub_product(t79, t246);
    let t257 = (t234 * t52).sub_product(t55, t256).sub_product(t57, t255).sub_product(t58, t254)
        .sub_product(t61, t249).add_product(t63, t248).add_product(t65, t246);
    let t258 = (t48 * t256).add_product(t46, t257).add_product(t50, t246);
    let t259 = (t38 * t257).sub_product(t36, t258).add_product(t36, t256).sub_product(t40, t246);
    let drum_v_y_dot_by_winding_force = (t31 * t247)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t247);
    let drum_v_x_dot_by_winding_force = (t30 * t247)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t247);
    let bobbin_v_y_dot_by_winding_force = t28.sub_product(inverse_bobbin_mass, t248)
        .sub_product(t29, t247);
    let bobbin_v_x_dot_by_winding_force = -t29.add_product(inverse_bobbin_mass, t249)
        .add_product(t28, t247);
    let rod_omega_dot_by_winding_force = (t26 * t251)
        .sub_product(R::literal(4_166.666_666_666_667), t253).sub_product(t27, t250);
    let rod_v_y_dot_by_winding_force = -(R::literal(5.0) * t250).add_product(t25, t252);
    let rod_v_x_dot_by_winding_force = (R::literal(-5.0) * t251).add_product(t24, t252);
    let cylinder_omega_dot_by_winding_force = (t22 * t254).sub_product(t21, t255)
        .add_product(R::literal(2_777.777_777_777_778), t253).add_product(t23, t252);
    let cylinder_v_y_dot_by_winding_force = (t20 * t252)
        .sub_product(R::literal(3.333_333_333_333_333_5), t254);
    let cylinder_v_x_dot_by_winding_force = -(t19 * t252)
        .add_product(R::literal(3.333_333_333_333_333_5), t255);
    let plate_omega_dot_by_winding_force = (-(p.bobbin_radius * R::literal(400.0)).add_product(t15,
        t257)).add_product(t16, t256).sub_product(t15, t255).add_product(t16, t254)
        .add_product(t17, t249).sub_product(t18, t248);
    let plate_v_y_dot_by_winding_force = (R::literal(0.833_333_333_333_333_4) * t254)
        .sub_product(R::literal(0.833_333_333_333_333_4), t256)
        .add_product(R::literal(0.833_333_333_333_333_4), t248);
    let plate_v_x_dot_by_winding_force = (R::literal(0.833_333_333_333_333_4) * t255)
        .sub_product(R::literal(0.833_333_333_333_333_4), t257)
        .add_product(R::literal(0.833_333_333_333_333_4), t249);
    let post_omega_dot_by_winding_force = (-(t13 * t258).add_product(t12, t259).add_product(t12,
        t257)).add_product(t13, t256).sub_product(t14, t246);
    let post_v_y_dot_by_winding_force = (R::literal(1.25) * t256).add_product(R::literal(1.25),
        t258);
    let post_v_x_dot_by_winding_force = (R::literal(1.25) * t257).sub_product(R::literal(1.25),
        t259);
    let t260 = R::literal(9.81) + bobbin_v_y_dot;
    let t261 = inverse_bobbin_mass * t204;
    let t262 = inverse_bobbin_mass * t260;
    let t263 = t262.add_product(t143, t261);
    let t264 = (t29 * t260).sub_product(t28, t204).sub_product(t144, t261).sub_product(t149, t263);
    let t265 = (t146 * t261).sub_product(t151, t263).sub_product(t156, t264) * t157;
    let t266 = (t264 * t154).sub_product(t156, t265);
    let t267 = (t263 * t147).sub_product(t149, t266).sub_product(t151, t265);
    let t268 = (-(t261 * t141).add_product(t143, t267)).add_product(t144, t266).sub_product(t146,
        t265);
    let t269 = (t138 * t267).add_product(t136, t268).add_product(t140, t265);
    let t270 = (t129 * t268).add_product(t127, t269).add_product(t131, t267).add_product(t133,
        t265);
    let t271 = (t118 * t269).add_product(t116, t270).sub_product(t120, t268).sub_product(t122, t267)
        .sub_product(t124, t265);
    let t272 = (t106 * t270).sub_product(t105, t271).sub_product(t107, t269).sub_product(t109, t268)
        .sub_product(t111, t267).sub_product(t113, t265);
    let t273 = (t96 * t271).add_product(t94, t272).add_product(t98, t268).add_product(t100, t267)
        .add_product(t102, t265);
    let t274 = (t83 * t272).sub_product(t82, t273).add_product(t85, t271).add_product(t87, t268)
        .add_product(t89, t267).add_product(t91, t265);
    let t275 = (t71 * t273).sub_product(t69, t274).add_product(t74, t268).sub_product(t77, t267)
        .sub_product(t79, t265);
    let t276 = (-(t57 * t274).add_product(t55, t275)).add_product(t58, t273).sub_product(t61, t268)
        .add_product(t63, t267).add_product(t65, t265);
    let t277 = (t48 * t275).add_product(t46, t276).add_product(t50, t265);
    let t278 = (t38 * t276).sub_product(t36, t277).add_product(t36, t275).sub_product(t40, t265);
    let drum_v_y_dot_by_bobbin_mass = (t31 * t266).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t266);
    let drum_v_x_dot_by_bobbin_mass = (t30 * t266).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t266);
    let bobbin_v_y_dot_by_bobbin_mass = -t262.add_product(inverse_bobbin_mass, t267)
        .add_product(t29, t266);
    let bobbin_v_x_dot_by_bobbin_mass = t261.sub_product(inverse_bobbin_mass, t268)
        .sub_product(t28, t266);
    let rod_omega_dot_by_bobbin_mass = (-(t26 * t270)
        .add_product(R::literal(4_166.666_666_666_667), t272)).add_product(t27, t269);
    let rod_v_y_dot_by_bobbin_mass = (R::literal(5.0) * t269).sub_product(t25, t271);
    let rod_v_x_dot_by_bobbin_mass = (R::literal(5.0) * t270).add_product(t24, t271);
    let cylinder_omega_dot_by_bobbin_mass = (-(t22 * t273).add_product(t21, t274))
        .add_product(R::literal(2_777.777_777_777_778), t272).add_product(t23, t271);
    let cylinder_v_y_dot_by_bobbin_mass = (t20 * t271)
        .add_product(R::literal(3.333_333_333_333_333_5), t273);
    let cylinder_v_x_dot_by_bobbin_mass = -(t19 * t271)
        .add_product(R::literal(3.333_333_333_333_333_5), t274);
    let plate_omega_dot_by_bobbin_mass = (t16 * t275).sub_product(t15, t276).sub_product(t15, t274)
        .sub_product(t16, t273).add_product(t17, t268).sub_product(t18, t267);
    let plate_v_y_dot_by_bobbin_mass = (-(R::literal(0.833_333_333_333_333_4) * t273)
        .add_product(R::literal(0.833_333_333_333_333_4), t275))
        .add_product(R::literal(0.833_333_333_333_333_4), t267);
    let plate_v_x_dot_by_bobbin_mass = (R::literal(0.833_333_333_333_333_4) * t274)
        .sub_product(R::literal(0.833_333_333_333_333_4), t276)
        .add_product(R::literal(0.833_333_333_333_333_4), t268);
    let post_omega_dot_by_bobbin_mass = (-(t13 * t277).add_product(t12, t278).add_product(t12,
        t276)).add_product(t13, t275).sub_product(t14, t265);
    let post_v_y_dot_by_bobbin_mass = (R::literal(1.25) * t275).add_product(R::literal(1.25), t277);
    let post_v_x_dot_by_bobbin_mass = (R::literal(1.25) * t276).sub_product(R::literal(1.25), t278);
    let t279 = slide_minus_spring_free_length * cos_cylinder_phi;
    let t280 = slide_minus_spring_free_length * sin_cylinder_phi;
    let t281 = slide_minus_spring_free_length * t7;
    let t282 = R::literal(3.333_333_333_333_333_5) * t279;
    let t283 = (-t282).add_product(t21, t281);
    let t284 = R::literal(3.333_333_333_333_333_5) * t280;
    let t285 = (-t284.add_product(t22, t281)).add_product(t82, t283);
    let t286 = R::literal(2_777.777_777_777_778) * t281;
    let t287 = (-t286).add_product(t83, t283).sub_product(t94, t285);
    let t288 = (t20 * t280).sub_product(t19, t279).sub_product(t23, t281).sub_product(t24, t279)
        .add_product(t25, t280).add_product(t85, t283).sub_product(t96, t285).sub_product(t105,
        t287);
    let t289 = R::literal(5.0) * t279;
    let t290 = t289.sub_product(t106, t287).sub_product(t116, t288);
    let t291 = R::literal(5.0) * t280;
    let t292 = t291.add_product(t107, t287).sub_product(t118, t288).add_product(t127, t290);
    let t293 = (t87 * t283).sub_product(t98, t285).sub_product(t109, t287).sub_product(t120, t288)
        .sub_product(t129, t290).sub_product(t136, t292);
    let t294 = (t89 * t283).sub_product(t100, t285).sub_product(t111, t287).sub_product(t122, t288)
        .sub_product(t131, t290).sub_product(t138, t292).sub_product(t143, t293);
    let t295 = (t144 * t293).sub_product(t149, t294);
    let t296 = (t91 * t283).sub_product(t102, t285).sub_product(t113, t287).sub_product(t124, t288)
        .sub_product(t133, t290).sub_product(t140, t292).sub_product(t146, t293).sub_product(t151,
        t294).sub_product(t156, t295) * t157;
    let t297 = (t295 * t154).sub_product(t156, t296);
    let t298 = (t294 * t147).sub_product(t149, t297).sub_product(t151, t296);
    let t299 = (t293 * t141).sub_product(t143, t298).add_product(t144, t297).sub_product(t146,
        t296);
    let t300 = (t292 * t134).sub_product(t136, t299).sub_product(t138, t298).sub_product(t140,
        t296);
    let t301 = (-(t290 * t125)).add_product(t127, t300).sub_product(t129, t299).sub_product(t131,
        t298).sub_product(t133, t296);
    let t302 = (t288 * t114).sub_product(t116, t301).sub_product(t118, t300).sub_product(t120, t299)
        .sub_product(t122, t298).sub_product(t124, t296);
    let t303 = (t287 * t103).sub_product(t105, t302).sub_product(t106, t301).add_product(t107, t300)
        .sub_product(t109, t299).sub_product(t111, t298).sub_product(t113, t296);
    let t304 = (t285 * t92).sub_product(t94, t303).sub_product(t96, t302).sub_product(t98, t299)
        .sub_product(t100, t298).sub_product(t102, t296);
    let t305 = (-(t283 * t80)).add_product(t82, t304).add_product(t83, t303).add_product(t85, t302)
        .add_product(t87, t299).add_product(t89, t298).add_product(t91, t296);
    let t306 = (-(t71 * t304).add_product(t69, t305)).add_product(t74, t299).sub_product(t77, t298)
        .sub_product(t79, t296);
    let t307 = (-(t57 * t305).add_product(t55, t306).add_product(t58, t304).add_product(t61, t299))
        .add_product(t63, t298).add_product(t65, t296);
    let t308 = (t48 * t306).add_product(t46, t307).add_product(t50, t296);
    let t309 = (t38 * t307).sub_product(t36, t308).add_product(t36, t306).sub_product(t40, t296);
    let drum_v_y_dot_by_spring_stiffness = (t31 * t297)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t297);
    let drum_v_x_dot_by_spring_stiffness = (t30 * t297)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t297);
    let bobbin_v_y_dot_by_spring_stiffness = -(t29 * t297).add_product(inverse_bobbin_mass, t298);
    let bobbin_v_x_dot_by_spring_stiffness = -(t28 * t297).add_product(inverse_bobbin_mass, t299);
    let rod_omega_dot_by_spring_stiffness = (t26 * t301)
        .sub_product(R::literal(4_166.666_666_666_667), t303).sub_product(t27, t300);
    let rod_v_y_dot_by_spring_stiffness = -t291.add_product(t25, t302).add_product(R::literal(5.0),
        t300);
    let rod_v_x_dot_by_spring_stiffness = (-t289).add_product(t24, t302)
        .sub_product(R::literal(5.0), t301);
    let cylinder_omega_dot_by_spring_stiffness = (-t286.add_product(t21, t305)).add_product(t22,
        t304).add_product(R::literal(2_777.777_777_777_778), t303).add_product(t23, t302);
    let cylinder_v_y_dot_by_spring_stiffness = t284
        .sub_product(R::literal(3.333_333_333_333_333_5), t304).add_product(t20, t302);
    let cylinder_v_x_dot_by_spring_stiffness = t282
        .sub_product(R::literal(3.333_333_333_333_333_5), t305).sub_product(t19, t302);
    let plate_omega_dot_by_spring_stiffness = (t16 * t306).sub_product(t15, t307).sub_product(t15,
        t305).add_product(t16, t304).add_product(t17, t299).sub_product(t18, t298);
    let plate_v_y_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t304)
        .sub_product(R::literal(0.833_333_333_333_333_4), t306)
        .add_product(R::literal(0.833_333_333_333_333_4), t298);
    let plate_v_x_dot_by_spring_stiffness = (R::literal(0.833_333_333_333_333_4) * t305)
        .sub_product(R::literal(0.833_333_333_333_333_4), t307)
        .add_product(R::literal(0.833_333_333_333_333_4), t299);
    let post_omega_dot_by_spring_stiffness = (-(t13 * t308).add_product(t12, t309).add_product(t12,
        t307)).add_product(t13, t306).sub_product(t14, t296);
    let post_v_y_dot_by_spring_stiffness = (R::literal(1.25) * t306).add_product(R::literal(1.25),
        t308);
    let post_v_x_dot_by_spring_stiffness = (R::literal(1.25) * t307).sub_product(R::literal(1.25),
        t309);
    let t310 = R::literal(3.333_333_333_333_333_5) * t205;
    let t311 = t310.sub_product(t21, t206);
    let t312 = R::literal(3.333_333_333_333_333_5) * t207;
    let t313 = t312.add_product(t22, t206).add_product(t82, t311);
    let t314 = R::literal(2_777.777_777_777_778) * t206;
    let t315 = t314.add_product(t83, t311).sub_product(t94, t313);
    let t316 = (t19 * t205).sub_product(t20, t207).add_product(t23, t206).add_product(t24, t205)
        .sub_product(t25, t207).add_product(t85, t311).sub_product(t96, t313).sub_product(t105,
        t315);
    let t317 = R::literal(5.0) * t205;
    let t318 = t317.add_product(t106, t315).add_product(t116, t316);
    let t319 = R::literal(5.0) * t207;
    let t320 = (-t319).add_product(t107, t315).sub_product(t118, t316).sub_product(t127, t318);
    let t321 = (t87 * t311).sub_product(t98, t313).sub_product(t109, t315).sub_product(t120, t316)
        .add_product(t129, t318).sub_product(t136, t320);
    let t322 = (t89 * t311).sub_product(t100, t313).sub_product(t111, t315).sub_product(t122, t316)
        .add_product(t131, t318).sub_product(t138, t320).sub_product(t143, t321);
    let t323 = (t144 * t321).sub_product(t149, t322);
    let t324 = (t91 * t311).sub_product(t102, t313).sub_product(t113, t315).sub_product(t124, t316)
        .add_product(t133, t318).sub_product(t140, t320).sub_product(t146, t321).sub_product(t151,
        t322).sub_product(t156, t323) * t157;
    let t325 = (t323 * t154).sub_product(t156, t324);
    let t326 = (t322 * t147).sub_product(t149, t325).sub_product(t151, t324);
    let t327 = (t321 * t141).sub_product(t143, t326).add_product(t144, t325).sub_product(t146,
        t324);
    let t328 = (t320 * t134).sub_product(t136, t327).sub_product(t138, t326).sub_product(t140,
        t324);
    let t329 = (t318 * t125).add_product(t127, t328).sub_product(t129, t327).sub_product(t131, t326)
        .sub_product(t133, t324);
    let t330 = (t316 * t114).sub_product(t116, t329).sub_product(t118, t328).sub_product(t120, t327)
        .sub_product(t122, t326).sub_product(t124, t324);
    let t331 = (t315 * t103).sub_product(t105, t330).sub_product(t106, t329).add_product(t107, t328)
        .sub_product(t109, t327).sub_product(t111, t326).sub_product(t113, t324);
    let t332 = (t313 * t92).sub_product(t94, t331).sub_product(t96, t330).sub_product(t98, t327)
        .sub_product(t100, t326).sub_product(t102, t324);
    let t333 = (-(t311 * t80)).add_product(t82, t332).add_product(t83, t331).add_product(t85, t330)
        .add_product(t87, t327).add_product(t89, t326).add_product(t91, t324);
    let t334 = (-(t71 * t332).add_product(t69, t333)).add_product(t74, t327).sub_product(t77, t326)
        .sub_product(t79, t324);
    let t335 = (-(t57 * t333).add_product(t55, t334).add_product(t58, t332).add_product(t61, t327))
        .add_product(t63, t326).add_product(t65, t324);
    let t336 = (t48 * t334).add_product(t46, t335).add_product(t50, t324);
    let t337 = (t38 * t335).sub_product(t36, t336).add_product(t36, t334).sub_product(t40, t324);
    let drum_v_y_dot_by_spring_free_length = (t31 * t325)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t325);
    let drum_v_x_dot_by_spring_free_length = (t30 * t325)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t325);
    let bobbin_v_y_dot_by_spring_free_length = -(t29 * t325).add_product(inverse_bobbin_mass, t326);
    let bobbin_v_x_dot_by_spring_free_length = -(t28 * t325).add_product(inverse_bobbin_mass, t327);
    let rod_omega_dot_by_spring_free_length = (t26 * t329)
        .sub_product(R::literal(4_166.666_666_666_667), t331).sub_product(t27, t328);
    let rod_v_y_dot_by_spring_free_length = t319.sub_product(t25, t330)
        .sub_product(R::literal(5.0), t328);
    let rod_v_x_dot_by_spring_free_length = t317.add_product(t24, t330)
        .sub_product(R::literal(5.0), t329);
    let cylinder_omega_dot_by_spring_free_length = t314.sub_product(t21, t333).add_product(t22,
        t332).add_product(R::literal(2_777.777_777_777_778), t331).add_product(t23, t330);
    let cylinder_v_y_dot_by_spring_free_length = (-t312
        .add_product(R::literal(3.333_333_333_333_333_5), t332)).add_product(t20, t330);
    let cylinder_v_x_dot_by_spring_free_length = -t310
        .add_product(R::literal(3.333_333_333_333_333_5), t333).add_product(t19, t330);
    let plate_omega_dot_by_spring_free_length = (t16 * t334).sub_product(t15, t335)
        .sub_product(t15, t333).add_product(t16, t332).add_product(t17, t327).sub_product(t18,
        t326);
    let plate_v_y_dot_by_spring_free_length = (R::literal(0.833_333_333_333_333_4) * t332)
        .sub_product(R::literal(0.833_333_333_333_333_4), t334)
        .add_product(R::literal(0.833_333_333_333_333_4), t326);
    let plate_v_x_dot_by_spring_free_length = (R::literal(0.833_333_333_333_333_4) * t333)
        .sub_product(R::literal(0.833_333_333_333_333_4), t335)
        .add_product(R::literal(0.833_333_333_333_333_4), t327);
    let post_omega_dot_by_spring_free_length = (-(t13 * t336).add_product(t12, t337)
        .add_product(t12, t335)).add_product(t13, t334).sub_product(t14, t324);
    let post_v_y_dot_by_spring_free_length = (R::literal(1.25) * t334)
        .add_product(R::literal(1.25), t336);
    let post_v_x_dot_by_spring_free_length = (R::literal(1.25) * t335)
        .sub_product(R::literal(1.25), t337);
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
    let t9 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t10 = R::literal(0.01) * t9;
    let t11 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t13 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t14 = t8 * R::literal(370.370_370_370_370_3);
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = R::literal(4.0) * t9;
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = t12 * t1;
    let t31 = R::literal(1.25) + t30;
    let t32 = R::literal(1.0) / t31;
    let t33 = t13 * t1;
    let t34 = t33 * t32;
    let t35 = R::literal(1.25) - t30;
    let t36 = t35 * t32;
    let t37 = t14 * t1;
    let t38 = t37 * t32;
    let t39 = t13 * t0;
    let t40 = R::literal(1.25) + t39;
    let t41 = t34 * t33;
    let t42 = R::literal(1.0) / (t41 - t40);
    let t43 = (t12 * t0).add_product(t36, t33);
    let t44 = t43 * t42;
    let t45 = R::literal(1.25) - t39 + t41;
    let t46 = t45 * t42;
    let t47 = (t14 * t0).sub_product(t38, t33);
    let t48 = t47 * t42;
    let t49 = t15 * t3;
    let t50 = R::literal(1.0) / (-(t31 + R::literal(0.833_333_333_333_333_4) + t49))
        .add_product(t36, t35).sub_product(t44, t43);
    let t51 = t16 * t3;
    let t52 = (t33 + t51).add_product(t34, t35).sub_product(t46, t43);
    let t53 = t52 * t50;
    let t54 = R::literal(0.833_333_333_333_333_4) - t49;
    let t55 = t54 * t50;
    let t56 = t51 * t50;
    let t57 = t17 * t3;
    let t58 = R::literal(0.833_333_333_333_333_4) + t57;
    let t59 = t58 * t50;
    let t60 = t18 * t3;
    let t61 = t60 * t50;
    let t62 = t37.add_product(t38, t35).add_product(t48, t43);
    let t63 = t62 * t50;
    let t64 = t16 * t2;
    let t65 = R::literal(1.0) / (t41 - (t40 + R::literal(0.833_333_333_333_333_4) + t64))
        .sub_product(t46, t45).sub_product(t53, t52);
    let t66 = (t15 * t2).sub_product(t55, t52);
    let t67 = t66 * t65;
    let t68 = (R::literal(0.833_333_333_333_333_4) - t64).sub_product(t56, t52);
    let t69 = t68 * t65;
    let t70 = t17 * t2;
    let t71 = t70.add_product(t59, t52);
    let t72 = t71 * t65;
    let t73 = t18 * t2;
    let t74 = (R::literal(0.833_333_333_333_333_4) + t73).add_product(t61, t52);
    let t75 = t74 * t65;
    let t76 = t47.sub_product(t48, t45).add_product(t63, t52);
    let t77 = t76 * t65;
    let t78 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t49
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t5).add_product(t55, t54)
        .add_product(t67, t66);
    let t79 = t51.add_product(t22, t5).sub_product(t56, t54).sub_product(t69, t66);
    let t80 = t79 * t78;
    let t81 = t21 * t78;
    let t82 = (-t19).add_product(t23, t5);
    let t83 = t82 * t78;
    let t84 = (t57 - R::literal(0.833_333_333_333_333_4)).sub_product(t59, t54).add_product(t72,
        t66);
    let t85 = t84 * t78;
    let t86 = (-t60).add_product(t61, t54).sub_product(t75, t66);
    let t87 = t86 * t78;
    let t88 = (t63 * t54).sub_product(t77, t66);
    let t89 = t88 * t78;
    let t90 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t64
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t56, t51)
        .add_product(t69, t68)).add_product(t80, t79);
    let t91 = (-t22).add_product(t81, t79);
    let t92 = t91 * t90;
    let t93 = t20.sub_product(t23, t4).add_product(t83, t79);
    let t94 = t93 * t90;
    let t95 = (-t70.add_product(t59, t51)).add_product(t72, t68).add_product(t85, t79);
    let t96 = t95 * t90;
    let t97 = (t73 - R::literal(0.833_333_333_333_333_4)).add_product(t61, t51).sub_product(t75,
        t68).add_product(t87, t79);
    let t98 = t97 * t90;
    let t99 = (t63 * t51).sub_product(t77, t68).add_product(t89, t79);
    let t100 = t99 * t90;
    let t101 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t81, t21)
        .sub_product(t92, t91);
    let t102 = (-t23).add_product(t83, t21).sub_product(t94, t91);
    let t103 = t102 * t101;
    let t104 = t26 * t101;
    let t105 = t27 * t101;
    let t106 = (t85 * t21).sub_product(t96, t91);
    let t107 = t106 * t101;
    let t108 = (t87 * t21).sub_product(t98, t91);
    let t109 = t108 * t101;
    let t110 = (t89 * t21).sub_product(t100, t91);
    let t111 = t110 * t101;
    let t112 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t83, t82).sub_product(t94, t93).sub_product(t103, t102);
    let t113 = t24.sub_product(t104, t102);
    let t114 = t113 * t112;
    let t115 = (-t25).add_product(t105, t102);
    let t116 = t115 * t112;
    let t117 = (t85 * t82).sub_product(t96, t93).sub_product(t107, t102);
    let t118 = t117 * t112;
    let t119 = (t87 * t82).sub_product(t98, t93).sub_product(t109, t102);
    let t120 = t119 * t112;
    let t121 = (t89 * t82).sub_product(t100, t93).sub_product(t111, t102);
    let t122 = t121 * t112;
    let t123 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t104, t26)
        .add_product(t114, t113);
    let t124 = (t27 * t6).add_product(t105, t26).sub_product(t116, t113);
    let t125 = t124 * t123;
    let t126 = (t107 * t26).add_product(t118, t113);
    let t127 = t126 * t123;
    let t128 = (t109 * t26).add_product(t120, t113);
    let t129 = t128 * t123;
    let t130 = (t111 * t26).add_product(t122, t113);
    let t131 = t130 * t123;
    let t132 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t105, t27).add_product(t116, t115)).add_product(t125, t124);
    let t133 = (t107 * t27).sub_product(t118, t115).sub_product(t127, t124);
    let t134 = t133 * t132;
    let t135 = (t109 * t27).sub_product(t120, t115).sub_product(t129, t124);
    let t136 = t135 * t132;
    let t137 = (t111 * t27).sub_product(t122, t115).sub_product(t131, t124);
    let t138 = t137 * t132;
    let t139 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + inverse_bobbin_mass).add_product(t59, t58).add_product(t72, t71)).add_product(t85, t84)
        .sub_product(t96, t95).sub_product(t107, t106).sub_product(t118, t117).add_product(t127,
        t126).sub_product(t134, t133);
    let t140 = (t18 * t10).add_product(t61, t58).add_product(t75, t71).add_product(t87, t84)
        .sub_product(t98, t95).sub_product(t109, t106).sub_product(t120, t117).add_product(t129,
        t126).sub_product(t136, t133);
    let t141 = t140 * t139;
    let t142 = t28 * t139;
    let t143 = (t63 * t58).add_product(t77, t71).add_product(t89, t84).sub_product(t100, t95)
        .sub_product(t111, t106).sub_product(t122, t117).add_product(t131, t126).sub_product(t138,
        t133);
    let t144 = t143 * t139;
    let t145 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t11)
        + inverse_bobbin_mass).add_product(t61, t60).add_product(t75, t74)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135).sub_product(t141, t140);
    let t146 = (-t29).add_product(t142, t140);
    let t147 = t146 * t145;
    let t148 = (-(t63 * t60).add_product(t77, t74)).add_product(t89, t86).sub_product(t100, t97)
        .sub_product(t111, t108).sub_product(t122, t119).add_product(t131, t128).sub_product(t138,
        t135).sub_product(t144, t140);
    let t149 = t148 * t145;
    let t150 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6)
        * bobbin_x_minus_drum_x_over_between;
    let t151 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6)
        * bobbin_y_minus_drum_y_over_between;
    let t152 = R::literal(1.0) / (t150 - ((t28 * bobbin_x_minus_drum_x_over_between)
        .add_product(t29, bobbin_y_minus_drum_y_over_between) + t150 + t151).add_product(t142, t28)
        .add_product(t147, t146) + t151);
    let t153 = (t144 * t28).sub_product(t149, t146);
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
    let t179 = t34 * t166;
    let t180 = R::literal(9.81) - t167 - t179;
    let t181 = t15 * bobbin_radius_times_winding_force;
    let t182 = (t181 - t166.add_product(t168, cos_plate_phi)).sub_product(t36, t166)
        .sub_product(t44, t180);
    let t183 = t16 * bobbin_radius_times_winding_force;
    let t184 = (R::literal(9.81) - (t167.add_product(t168, sin_plate_phi) + R::literal(9.81))
        - t183 - t179).sub_product(t46, t180).sub_product(t53, t182);
    let t185 = t181.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .sub_product(R::literal(3.333_333_333_333_333_5), t157).add_product(t21, t161)
        .sub_product(t55, t182).sub_product(t67, t184);
    let t186 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t183)
        .add_product(R::literal(3.333_333_333_333_333_5), t160).add_product(t22, t161)
        .add_product(t56, t182).add_product(t69, t184)).add_product(t80, t185);
    let t187 = (R::literal(-2_777.777_777_777_778) * t161).add_product(t81, t185).sub_product(t92,
        t186);
    let t188 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t157)
        .add_product(t20, t160).sub_product(t23, t161).sub_product(t24, t157).add_product(t25, t162)
        .add_product(t83, t185).sub_product(t94, t186);
    let t189 = t188.sub_product(t103, t187);
    let t190 = (t169 * cos_rod_phi).add_product(R::literal(5.0), t157).sub_product(t104, t187)
        .sub_product(t114, t189);
    let t191 = (t169 * sin_rod_phi).add_product(R::literal(5.0), t162).add_product(t105, t187)
        .sub_product(t116, t189).add_product(t125, t190);
    let t192 = (t11 * plate_omega_squared).sub_product(t17, bobbin_radius_times_winding_force)
        .add_product(inverse_bobbin_mass, t163).sub_product(t59, t182).add_product(t72, t184)
        .add_product(t85, t185).sub_product(t96, t186).sub_product(t107, t187).sub_product(t118,
        t189).sub_product(t127, t190).sub_product(t134, t191);
    let t193 = R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared).add_product(t18,
        bobbin_radius_times_winding_force).sub_product(inverse_bobbin_mass, t164).add_product(t61,
        t182).sub_product(t75, t184).add_product(t87, t185).sub_product(t98, t186)
        .sub_product(t109, t187).sub_product(t120, t189).sub_product(t129, t190).sub_product(t136,
        t191).sub_product(t141, t192);
    let t194 = R::literal(9.809_999_999_999_999) * bobbin_y_minus_drum_y_over_between;
    let t195 = ((-t178).add_product(t28, t163).sub_product(t29, t164) - t194).add_product(t142,
        t192).sub_product(t147, t193) + t194;
    let t196 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t38, t166).sub_product(t48, t180).add_product(t63, t182)
        .sub_product(t77, t184).add_product(t89, t185).sub_product(t100, t186).sub_product(t111,
        t187).sub_product(t122, t189).sub_product(t131, t190).sub_product(t138, t191)
        .sub_product(t144, t192).sub_product(t149, t193).sub_product(t154, t195);
    let t197 = t196 * (R::literal(1.0) / (-(t14 * t8)).add_product(t38, t37).sub_product(t48, t47)
        .sub_product(t63, t62).sub_product(t77, t76).add_product(t89, t88).sub_product(t100, t99)
        .sub_product(t111, t110).sub_product(t122, t121).add_product(t131, t130).sub_product(t138,
        t137).sub_product(t144, t143).sub_product(t149, t148).sub_product(t154, t153));
    let contact = (-(t195 * t152)).add_product(t154, t197);
    let stop = -t197;
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 1073 operations.
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
    let t9 = sin_plate_phi.add_product(R::literal(10.0), cos_plate_phi);
    let t10 = R::literal(0.01) * t9;
    let t11 = (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t13 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t14 = t8 * R::literal(370.370_370_370_370_3);
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = R::literal(4.0) * t9;
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(1.25) + t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(1.25) + t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t43 - t42);
    let t45 = (t12 * t0).add_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 + t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).sub_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0) / (-(t33 + R::literal(0.833_333_333_333_333_4) + t51))
        .add_product(t38, t37).sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).add_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t39.add_product(t40, t37).add_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0) / (t43 - (t42 + R::literal(0.833_333_333_333_333_4) + t66))
        .sub_product(t48, t47).sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = t17 * t2;
    let t73 = t72.add_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).add_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0) / (R::literal(0.833_333_333_333_333_4) + t51
        + R::literal(3.333_333_333_333_333_5)).add_product(t21, t5).add_product(t57, t56)
        .add_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = t21 * t80;
    let t84 = (-t19).add_product(t23, t5);
    let t85 = t84 * t80;
    let t86 = (t59 - R::literal(0.833_333_333_333_333_4)).sub_product(t61, t56).add_product(t74,
        t68);
    let t87 = t86 * t80;
    let t88 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t89 = t88 * t80;
    let t90 = (t65 * t56).sub_product(t79, t68);
    let t91 = t90 * t80;
    let t92 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4) + t66
        + R::literal(3.333_333_333_333_333_5)).add_product(t22, t4).add_product(t58, t53)
        .add_product(t71, t70)).add_product(t82, t81);
    let t93 = (-t22).add_product(t83, t81);
    let t94 = t93 * t92;
    let t95 = t20.sub_product(t23, t4).add_product(t85, t81);
    let t96 = t95 * t92;
    let t97 = (-t72.add_product(t61, t53)).add_product(t74, t70).add_product(t87, t81);
    let t98 = t97 * t92;
    let t99 = (t75 - R::literal(0.833_333_333_333_333_4)).add_product(t63, t53).sub_product(t77,
        t70).add_product(t89, t81);
    let t100 = t99 * t92;
    let t101 = (t65 * t53).sub_product(t79, t70).add_product(t91, t81);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).add_product(t83, t21)
        .sub_product(t94, t93);
    let t104 = (-t23).add_product(t85, t21).sub_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t26 * t103;
    let t107 = t27 * t103;
    let t108 = (t87 * t21).sub_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t21).sub_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t21).sub_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t19 * sin_cylinder_phi).add_product(t20, cos_cylinder_phi)
        .add_product(t23, slide).add_product(t24, sin_cylinder_phi).add_product(t25,
        cos_cylinder_phi)).add_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t24.sub_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = (-t25).add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (t87 * t84).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (t89 * t84).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (t91 * t84).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(5.0).add_product(t26, t6).add_product(t106, t26)
        .add_product(t116, t115);
    let t126 = (t27 * t6).add_product(t107, t26).sub_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (t109 * t26).add_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (t111 * t26).add_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (t113 * t26).add_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / (-R::literal(5.0).add_product(t27, R::literal(0.06) * cos_rod_phi)
        .add_product(t107, t27).add_product(t118, t117)).add_product(t127, t126);
    let t135 = (t109 * t27).sub_product(t120, t117).sub_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (t111 * t27).sub_product(t122, t117).sub_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (t113 * t27).sub_product(t124, t117).sub_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t17, t10)
        + inverse_bobbin_mass).add_product(t61, t60).add_product(t74, t73)).add_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).add_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t18 * t10).add_product(t63, t60).add_product(t77, t73).add_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).add_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t28 * t141;
    let t145 = (t65 * t60).add_product(t79, t73).add_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).add_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (-(R::literal(0.833_333_333_333_333_4).add_product(t18, t11)
        + inverse_bobbin_mass).add_product(t63, t62).add_product(t77, t76)).add_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).add_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t29).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (-(t65 * t62).add_product(t79, t76)).add_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).add_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t30 * bobbin_x_minus_drum_x_over_between;
    let t153 = t31 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (t152 - ((t28 * bobbin_x_minus_drum_x_over_between)
        .add_product(t29, bobbin_y_minus_drum_y_over_between) + t152 + t153).add_product(t144, t28)
        .add_product(t149, t148) + t153);
    let t155 = (t146 * t28).sub_product(t151, t148);
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
    let t186 = t36 * t173;
    let t187 = R::literal(9.81) - t174 - t186;
    let t188 = t15 * bobbin_radius_times_winding_force;
    let t189 = (t188 - t173.add_product(t175, cos_plate_phi)).sub_product(t38, t173)
        .sub_product(t46, t187);
    let t190 = t16 * bobbin_radius_times_winding_force;
    let t191 = (R::literal(9.81) - (t174.add_product(t175, sin_plate_phi) + R::literal(9.81))
        - t190 - t186).sub_product(t48, t187).sub_product(t55, t189);
    let t192 = R::literal(3.333_333_333_333_333_5) * t160;
    let t193 = (t188.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) - t192).add_product(t21, t166)
        .sub_product(t57, t189).sub_product(t69, t191);
    let t194 = R::literal(3.333_333_333_333_333_5) * t164;
    let t195 = (-(R::literal(9.81).add_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) + t190 + t194)
        .add_product(t22, t166).add_product(t58, t189).add_product(t71, t191)).add_product(t82,
        t193);
    let t196 = R::literal(2_777.777_777_777_778) * t166;
    let t197 = (-t196).add_product(t83, t193).sub_product(t94, t195);
    let t198 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t19, t160)
        .add_product(t20, t164).sub_product(t23, t166).sub_product(t24, t160).add_product(t25, t168)
        .add_product(t85, t193).sub_product(t96, t195);
    let t199 = t198.sub_product(t105, t197);
    let t200 = R::literal(5.0) * t160;
    let t201 = t200.add_product(t176, cos_rod_phi).sub_product(t106, t197).sub_product(t116, t199);
    let t202 = R::literal(5.0) * t168;
    let t203 = t202.add_product(t176, sin_rod_phi).add_product(t107, t197).sub_product(t118, t199)
        .add_product(t127, t201);
    let t204 = inverse_bobbin_mass * t169;
    let t205 = ((t11 * plate_omega_squared).sub_product(t17, bobbin_radius_times_winding_force)
        + t204).sub_product(t61, t189).add_product(t74, t191).add_product(t87, t193)
        .sub_product(t98, t195).sub_product(t109, t197).sub_product(t120, t199).sub_product(t129,
        t201).sub_product(t136, t203);
    let t206 = inverse_bobbin_mass * t171;
    let t207 = (R::literal(-9.81).add_product((R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi), plate_omega_squared).add_product(t18,
        bobbin_radius_times_winding_force) - t206).add_product(t63, t189).sub_product(t77, t191)
        .add_product(t89, t193).sub_product(t100, t195).sub_product(t111, t197).sub_product(t122,
        t199).sub_product(t131, t201).sub_product(t138, t203).sub_product(t143, t205);
    let t208 = R::literal(9.809_999_999_999_999) * bobbin_y_minus_drum_y_over_between;
    let t209 = ((-t185).add_product(t28, t169).sub_product(t29, t171) - t208).add_product(t144,
        t205).sub_product(t149, t207) + t208;
    let t210 = (-((R::literal(0.044) * cos_post_phi).sub_product(R::literal(0.143), sin_post_phi)
        * post_omega_squared)).add_product(t40, t173).sub_product(t50, t187).add_product(t65, t189)
        .sub_product(t79, t191).add_product(t91, t193).sub_product(t102, t195).sub_product(t113,
        t197).sub_product(t124, t199).sub_product(t133, t201).sub_product(t140, t203)
        .sub_product(t146, t205).sub_product(t151, t207).sub_product(t156, t209);
    let t211 = t210 * (R::literal(1.0) / (-(t14 * t8)).add_product(t40, t39).sub_product(t50, t49)
        .sub_product(t65, t64).sub_product(t79, t78).add_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).add_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155));
    let t212 = (t209 * t154).sub_product(t156, t211);
    let t213 = (t207 * t147).sub_product(t149, t212).sub_product(t151, t211);
    let t214 = (t205 * t141).sub_product(t143, t213).add_product(t144, t212).sub_product(t146,
        t211);
    let t215 = (t203 * t134).sub_product(t136, t214).sub_product(t138, t213).sub_product(t140,
        t211);
    let t216 = (-(t201 * t125)).add_product(t127, t215).sub_product(t129, t214).sub_product(t131,
        t213).sub_product(t133, t211);
    let t217 = (t199 * t114).sub_product(t116, t216).sub_product(t118, t215).sub_product(t120, t214)
        .sub_product(t122, t213).sub_product(t124, t211);
    let t218 = (t197 * t103).sub_product(t105, t217).sub_product(t106, t216).add_product(t107, t215)
        .sub_product(t109, t214).sub_product(t111, t213).sub_product(t113, t211);
    let t219 = (t195 * t92).sub_product(t94, t218).sub_product(t96, t217).sub_product(t98, t214)
        .sub_product(t100, t213).sub_product(t102, t211);
    let t220 = (-(t193 * t80)).add_product(t82, t219).add_product(t83, t218).add_product(t85, t217)
        .add_product(t87, t214).add_product(t89, t213).add_product(t91, t211);
    let t221 = (t191 * t67).sub_product(t69, t220).sub_product(t71, t219).add_product(t74, t214)
        .sub_product(t77, t213).sub_product(t79, t211);
    let t222 = (t189 * t52).sub_product(t55, t221).sub_product(t57, t220).sub_product(t58, t219)
        .sub_product(t61, t214).add_product(t63, t213).add_product(t65, t211);
    let t223 = (t187 * t44).sub_product(t46, t222).sub_product(t48, t221).sub_product(t50, t211);
    let t224 = (t173 * t34).add_product(t36, t223).add_product(t38, t222).add_product(t36, t221)
        .sub_product(t40, t211);
    let drum_v_y_dot = (-R::literal(9.809_999_999_999_999)
        .add_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t212))).add_product(t31, t212);
    let drum_v_x_dot = (t30 * t212).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t212);
    let bobbin_v_y_dot = t206.sub_product(inverse_bobbin_mass, t213).sub_product(t29, t212);
    let rod_omega_dot = (t26 * t216).sub_product(R::literal(4_166.666_666_666_667), t218)
        .sub_product(t27, t215);
    let rod_v_x_dot = (-t200).add_product(t24, t217).sub_product(R::literal(5.0), t216);
    let cylinder_omega_dot = (-t196.add_product(t21, t220)).add_product(t22, t219)
        .add_product(R::literal(2_777.777_777_777_778), t218).add_product(t23, t217);
    let cylinder_v_y_dot = t194.sub_product(R::literal(3.333_333_333_333_333_5), t219)
        .add_product(t20, t217);
    let cylinder_v_x_dot = t192.sub_product(R::literal(3.333_333_333_333_333_5), t220)
        .sub_product(t19, t217);
    let plate_omega_dot = (-(bobbin_radius_times_winding_force * R::literal(400.0))
        .add_product(t15, t222)).add_product(t16, t221).sub_product(t15, t220).add_product(t16,
        t219).add_product(t17, t214).sub_product(t18, t213);
    let plate_v_y_dot = (-R::literal(9.81).add_product(R::literal(0.833_333_333_333_333_4), t221))
        .add_product(R::literal(0.833_333_333_333_333_4), t219)
        .add_product(R::literal(0.833_333_333_333_333_4), t213);
    let plate_v_x_dot = (R::literal(0.833_333_333_333_333_4) * t220)
        .sub_product(R::literal(0.833_333_333_333_333_4), t222)
        .add_product(R::literal(0.833_333_333_333_333_4), t214);
    let post_omega_dot = (t13 * t223).sub_product(t12, t224).sub_product(t12, t222)
        .add_product(t13, t221).sub_product(t14, t211);
    let post_v_y_dot = (-R::literal(9.81).add_product(R::literal(1.25), t223))
        .add_product(R::literal(1.25), t221);
    let post_v_x_dot = (R::literal(1.25) * t222).sub_product(R::literal(1.25), t224);
    let t225 = (R::literal(7.848) * post_v_y).add_product(R::literal(11.772), plate_v_y)
        .sub_product(t159, cylinder_v_x).add_product(t162, cylinder_v_y).add_product(t165,
        cylinder_omega).add_product(t159, rod_v_x).add_product(t167, rod_v_y).add_product(t170,
        bobbin_v_y).add_product(R::literal(14.715), drum_v_y).add_product(R::literal(0.8)
        * post_v_x, post_v_x_dot).add_product(R::literal(0.8) * post_v_y, post_v_y_dot)
        .add_product(R::literal(0.0027) * post_omega, post_omega_dot).add_product(R::literal(1.2)
        * plate_v_x, plate_v_x_dot).add_product(R::literal(1.2) * plate_v_y, plate_v_y_dot)
        .add_product(R::literal(0.0025) * plate_omega, plate_omega_dot).add_product(R::literal(0.3)
        * cylinder_v_x, cylinder_v_x_dot);
    PowerBalance {
        stored_rate: t225.add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot).sub_product(R::literal(0.2)
            * rod_v_y, t202.add_product(t25, t217).add_product(R::literal(5.0), t215))
            .add_product(R::literal(0.00024) * rod_omega, rod_omega_dot).sub_product(p.bobbin_mass
            * bobbin_v_x, t204.add_product(inverse_bobbin_mass, t214).add_product(t28, t212))
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
        R::literal(-1.0), R::literal(-0.01) * sin_plate_phi.add_product(R::literal(10.0),
        cos_plate_phi), R::literal(1.0), R::literal(-1.0), (R::literal(0.01)
        * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), bobbin_x_minus_drum_x_over_between,
        bobbin_y_minus_drum_y_over_between, -bobbin_x_minus_drum_x_over_between,
        -bobbin_y_minus_drum_y_over_between, (R::literal(0.044)
        * sin_post_phi).add_product(R::literal(0.143), cos_post_phi)]
}
