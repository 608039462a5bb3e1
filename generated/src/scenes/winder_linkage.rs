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
// Operations: rate 1006, forcing 51, rate_jacobian 7665, parameter_jacobian 2220, outputs 800,
//     energy 72, power_balance 1099, constraint_values 62, constraint_rates 89, constraint_matrix 48,
//     prepare 5, prepared_rate 1001, prepared_rate_jacobian 7660.

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

/// What `rate` and `rate_jacobian` need of the parameters, once a run. 5 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t0 = R::literal(9.81) * p.bobbin_mass;
    let t1 = -(bobbin_radius_times_winding_force * R::literal(400.0));
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

/// As `rate`, with the constants of the parameters from `prepare`. 1001 operations.
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
    let t32 = R::literal(-1.25) - t31;
    let t33 = R::literal(1.0) / t32;
    let t34 = t12 * t1;
    let t35 = t34 * t33;
    let t36 = R::literal(1.25) - t31;
    let t37 = t36 * t33;
    let t38 = t13 * t1;
    let t39 = t38 * t33;
    let t40 = t12 * t0;
    let t41 = R::literal(-1.25) - t40;
    let t42 = t35 * t34;
    let t43 = R::literal(1.0) / (t41 - t42);
    let t44 = (t11 * t0).sub_product(t37, t34);
    let t45 = t44 * t43;
    let t46 = R::literal(1.25) - t40 - t42;
    let t47 = t46 * t43;
    let t48 = (t13 * t0).add_product(t39, t34);
    let t49 = t48 * t43;
    let t50 = t14 * t3;
    let t51 = R::literal(1.0) / (t32 - R::literal(0.833_333_333_333_333_4) - t50).sub_product(t37,
        t36).sub_product(t45, t44);
    let t52 = t15 * t3;
    let t53 = (t34 + t52).sub_product(t35, t36).sub_product(t47, t44);
    let t54 = t53 * t51;
    let t55 = R::literal(0.833_333_333_333_333_4) - t50;
    let t56 = t55 * t51;
    let t57 = t52 * t51;
    let t58 = t16 * t3;
    let t59 = R::literal(0.833_333_333_333_333_4) + t58;
    let t60 = t59 * t51;
    let t61 = t17 * t3;
    let t62 = t61 * t51;
    let t63 = (-t38).add_product(t39, t36).sub_product(t49, t44);
    let t64 = t63 * t51;
    let t65 = t15 * t2;
    let t66 = R::literal(1.0) / (t41 - R::literal(0.833_333_333_333_333_4) - t65 - t42)
        .sub_product(t47, t46).sub_product(t54, t53);
    let t67 = (t14 * t2).sub_product(t56, t53);
    let t68 = t67 * t66;
    let t69 = (R::literal(0.833_333_333_333_333_4) - t65).sub_product(t57, t53);
    let t70 = t69 * t66;
    let t71 = -(t16 * t2);
    let t72 = t71.sub_product(t60, t53);
    let t73 = t72 * t66;
    let t74 = t17 * t2;
    let t75 = (R::literal(0.833_333_333_333_333_4) + t74).add_product(t62, t53);
    let t76 = t75 * t66;
    let t77 = t48.sub_product(t49, t46).sub_product(t64, t53);
    let t78 = t77 * t66;
    let t79 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t50
        - R::literal(3.333_333_333_333_333_5)).sub_product(t20, t5).sub_product(t56, t55)
        .sub_product(t68, t67);
    let t80 = t52.add_product(t21, t5).sub_product(t57, t55).sub_product(t70, t67);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = (-t18).add_product(t22, t5);
    let t85 = t84 * t79;
    let t86 = (R::literal(-0.833_333_333_333_333_4) + t58).sub_product(t60, t55).sub_product(t73,
        t67);
    let t87 = t86 * t79;
    let t88 = (-t61).add_product(t62, t55).sub_product(t76, t67);
    let t89 = t88 * t79;
    let t90 = (-(t64 * t55)).sub_product(t78, t67);
    let t91 = t90 * t79;
    let t92 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t65
        - R::literal(3.333_333_333_333_333_5)).sub_product(t21, t4).sub_product(t57, t52)
        .sub_product(t70, t69).sub_product(t81, t80);
    let t93 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).add_product(t83, t80);
    let t94 = t93 * t92;
    let t95 = t19.sub_product(t22, t4).sub_product(t85, t80);
    let t96 = t95 * t92;
    let t97 = t71.sub_product(t60, t52).sub_product(t73, t69).sub_product(t87, t80);
    let t98 = t97 * t92;
    let t99 = (R::literal(-0.833_333_333_333_333_4) + t74).add_product(t62, t52).sub_product(t76,
        t69).sub_product(t89, t80);
    let t100 = t99 * t92;
    let t101 = (-(t64 * t52)).sub_product(t78, t69).sub_product(t91, t80);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).sub_product(t83, t82)
        .sub_product(t94, t93);
    let t104 = (-t22).add_product(t85, t82).sub_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t25 * t103;
    let t107 = t26 * t103;
    let t108 = (t87 * t82).sub_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t82).sub_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t82).sub_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t19 * cos_cylinder_phi)).sub_product(t18, sin_cylinder_phi)
        .sub_product(t22, slide).sub_product(t23, sin_cylinder_phi).sub_product(t24,
        cos_cylinder_phi).sub_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t23.sub_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = (-t24).add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (-(t87 * t84)).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (-(t89 * t84)).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (-(t91 * t84)).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(-5.0).sub_product(t25, t6).sub_product(t106, t25)
        .sub_product(t116, t115);
    let t126 = (t26 * t6).add_product(t107, t25).sub_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (-(t109 * t25)).sub_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (-(t111 * t25)).sub_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (-(t113 * t25)).sub_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / R::literal(-5.0).sub_product(t26, R::literal(0.06) * cos_rod_phi)
        .sub_product(t107, t26).sub_product(t118, t117).sub_product(t127, t126);
    let t135 = (t109 * t26).sub_product(t120, t117).sub_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (t111 * t26).sub_product(t122, t117).sub_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (t113 * t26).sub_product(t124, t117).sub_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t16, t9)
        - c.inverse_bobbin_mass).sub_product(t60, t59).sub_product(t73, t72).sub_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).sub_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t17 * t9).add_product(t62, t59).sub_product(t76, t72).sub_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).sub_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t27 * t141;
    let t145 = (-(t64 * t59)).sub_product(t78, t72).sub_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).sub_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
        - c.inverse_bobbin_mass).sub_product(t62, t61).sub_product(t76, t75).sub_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).sub_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t28).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (t64 * t61).sub_product(t78, t75).sub_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).sub_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t29 * bobbin_x_minus_drum_x_over_between;
    let t153 = t30 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (((-(t28 * bobbin_y_minus_drum_y_over_between)).sub_product(t27,
        bobbin_x_minus_drum_x_over_between) - t152 - t153).sub_product(t144, t27).sub_product(t149,
        t148) + t152 + t153);
    let t155 = (t146 * t27).sub_product(t151, t148);
    let t156 = t155 * t154;
    let t157 = R::literal(1.0) / (-(t13 * t8)).sub_product(t39, t38).sub_product(t49, t48)
        .sub_product(t64, t63).sub_product(t78, t77).sub_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).sub_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155);
    let t158 = R::literal(50.0) * slide_rate;
    let t159 = t158 * cos_cylinder_phi;
    let t160 = p.spring_stiffness * (slide - p.spring_free_length);
    let t161 = t160 * cos_cylinder_phi;
    let t162 = t159 + t161;
    let t163 = t160 * sin_cylinder_phi;
    let t164 = t158 * sin_cylinder_phi;
    let t165 = t164 - (R::literal(2.943) - t163);
    let t166 = (-(t160 * t7)).sub_product(t158, t7);
    let t167 = -t159 - t161;
    let t168 = -t164 - (R::literal(1.962) + t163);
    let t169 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t170 = p.winding_force * bobbin_x_minus_drum_x / between - c.t0;
    let post_omega_squared = post_omega * post_omega;
    let t171 = R::literal(0.1) * post_omega_squared;
    let t172 = t171 * cos_post_phi;
    let t173 = t171 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t174 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t175 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t176 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t177 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t178 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t179 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t180 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t181 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t182 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t183 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t184 = (bobbin_v_x * (bobbin_v_x_over_between + t178 + t179 - t176 - t177
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t182 + t183
        - t180 - t181 - drum_v_y_over_between).add_product(drum_v_x, t176 + t177
        + drum_v_x_over_between - bobbin_v_x_over_between - t178 - t179).add_product(drum_v_y, t180
        + t181 + drum_v_y_over_between - bobbin_v_y_over_between - t182 - t183);
    let t185 = t35 * t172;
    let t186 = -t173 - R::literal(-9.81) + t185;
    let t187 = t14 * c.bobbin_radius_times_winding_force;
    let t188 = (t187 - t172.add_product(t174, cos_plate_phi)).add_product(t37, t172)
        .sub_product(t45, t186);
    let t189 = t15 * c.bobbin_radius_times_winding_force;
    let t190 = (-t173.add_product(t174, sin_plate_phi) - R::literal(9.81) - R::literal(-9.81)
        - t189 + t185).sub_product(t47, t186).sub_product(t54, t188);
    let t191 = R::literal(3.333_333_333_333_333_5) * t162;
    let t192 = (t187.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) - t191).sub_product(t20, t166)
        .sub_product(t56, t188).sub_product(t68, t190);
    let t193 = R::literal(3.333_333_333_333_333_5) * t165;
    let t194 = (R::literal(-9.81).sub_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) - t189 - t193)
        .add_product(t21, t166).sub_product(t57, t188).sub_product(t70, t190).sub_product(t81,
        t192);
    let t195 = (-(R::literal(-2_777.777_777_777_778) * t166)).add_product(t83, t192)
        .sub_product(t94, t194);
    let t196 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t162)
        .add_product(t19, t165).add_product(t22, t166).add_product(t23, t167).sub_product(t24, t168)
        .sub_product(t85, t192).sub_product(t96, t194);
    let t197 = t196.sub_product(t105, t195);
    let t198 = R::literal(5.0) * t167;
    let t199 = (-t198).add_product(t175, cos_rod_phi).sub_product(t106, t195).sub_product(t116,
        t197);
    let t200 = R::literal(5.0) * t168;
    let t201 = (-t200).add_product(t175, sin_rod_phi).add_product(t107, t195).sub_product(t118,
        t197).sub_product(t127, t199);
    let t202 = c.inverse_bobbin_mass * t169;
    let t203 = ((t10 * plate_omega_squared).sub_product(t16, c.bobbin_radius_times_winding_force)
        + t202).sub_product(t60, t188).sub_product(t73, t190).sub_product(t87, t192)
        .sub_product(t98, t194).sub_product(t109, t195).sub_product(t120, t197).sub_product(t129,
        t199).sub_product(t136, t201);
    let t204 = c.inverse_bobbin_mass * t170;
    let t205 = (R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        c.bobbin_radius_times_winding_force) - t204).add_product(t62, t188).sub_product(t76, t190)
        .sub_product(t89, t192).sub_product(t100, t194).sub_product(t111, t195).sub_product(t122,
        t197).sub_product(t131, t199).sub_product(t138, t201).sub_product(t143, t203);
    let t206 = (-t184).add_product(t27, t169).sub_product(t28, t170)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t144, t203).sub_product(t149, t205)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t207 = ((R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi)
        * post_omega_squared).sub_product(t39, t172).sub_product(t49, t186).sub_product(t64, t188)
        .sub_product(t78, t190).sub_product(t91, t192).sub_product(t102, t194).sub_product(t113,
        t195).sub_product(t124, t197).sub_product(t133, t199).sub_product(t140, t201)
        .sub_product(t146, t203).sub_product(t151, t205).sub_product(t156, t206) * t157;
    let t208 = (t206 * t154).sub_product(t156, t207);
    let t209 = (t205 * t147).sub_product(t149, t208).sub_product(t151, t207);
    let t210 = (t203 * t141).sub_product(t143, t209).add_product(t144, t208).sub_product(t146,
        t207);
    let t211 = (t201 * t134).sub_product(t136, t210).sub_product(t138, t209).sub_product(t140,
        t207);
    let t212 = (t199 * t125).sub_product(t127, t211).sub_product(t129, t210).sub_product(t131, t209)
        .sub_product(t133, t207);
    let t213 = (t197 * t114).sub_product(t116, t212).sub_product(t118, t211).sub_product(t120, t210)
        .sub_product(t122, t209).sub_product(t124, t207);
    let t214 = (t195 * t103).sub_product(t105, t213).sub_product(t106, t212).add_product(t107, t211)
        .sub_product(t109, t210).sub_product(t111, t209).sub_product(t113, t207);
    let t215 = (t194 * t92).sub_product(t94, t214).sub_product(t96, t213).sub_product(t98, t210)
        .sub_product(t100, t209).sub_product(t102, t207);
    let t216 = (t192 * t79).sub_product(t81, t215).add_product(t83, t214).sub_product(t85, t213)
        .sub_product(t87, t210).sub_product(t89, t209).sub_product(t91, t207);
    let t217 = (t190 * t66).sub_product(t68, t216).sub_product(t70, t215).sub_product(t73, t210)
        .sub_product(t76, t209).sub_product(t78, t207);
    let t218 = (t188 * t51).sub_product(t54, t217).sub_product(t56, t216).sub_product(t57, t215)
        .sub_product(t60, t210).add_product(t62, t209).sub_product(t64, t207);
    let t219 = (t186 * t43).sub_product(t45, t218).sub_product(t47, t217).sub_product(t49, t207);
    let t220 = (-(t172 * t33)).sub_product(t35, t219).sub_product(t37, t218).sub_product(t35, t217)
        .add_product(t39, t207);
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        .sub_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t208)).add_product(t30, t208);
    let drum_v_x_dot = (t29 * t208).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t208);
    let bobbin_v_y_dot = t204.sub_product(c.inverse_bobbin_mass, t209).sub_product(t28, t208);
    let bobbin_v_x_dot = (-t202).sub_product(c.inverse_bobbin_mass, t210).sub_product(t27, t208);
    let rod_omega_dot = (t25 * t212).sub_product(R::literal(4_166.666_666_666_667), t214)
        .sub_product(t26, t211);
    let rod_v_y_dot = t200.sub_product(t24, t213).sub_product(R::literal(5.0), t211);
    let rod_v_x_dot = t198.add_product(t23, t213).sub_product(R::literal(5.0), t212);
    let cylinder_omega_dot = (t166 * R::literal(2_777.777_777_777_778)).sub_product(t20, t216)
        .add_product(t21, t215).sub_product(R::literal(-2_777.777_777_777_778), t214)
        .add_product(t22, t213);
    let cylinder_v_y_dot = t193.sub_product(R::literal(3.333_333_333_333_333_5), t215)
        .add_product(t19, t213);
    let cylinder_v_x_dot = t191.sub_product(R::literal(3.333_333_333_333_333_5), t216)
        .sub_product(t18, t213);
    let plate_omega_dot = c.t1.sub_product(t14, t218).add_product(t15, t217).sub_product(t14, t216)
        .add_product(t15, t215).add_product(t16, t210).sub_product(t17, t209);
    let plate_v_y_dot = R::literal(-9.81).sub_product(R::literal(0.833_333_333_333_333_4), t217)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t215)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t209);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t216))
        .sub_product(R::literal(0.833_333_333_333_333_4), t218)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t210);
    let post_omega_dot = (t12 * t219).sub_product(t11, t220).sub_product(t11, t218)
        .add_product(t12, t217).sub_product(t13, t207);
    let post_v_y_dot = R::literal(-9.81).sub_product(R::literal(1.25), t219)
        .sub_product(R::literal(-1.25), t217);
    let post_v_x_dot = (-(R::literal(-1.25) * t218)).sub_product(R::literal(1.25), t220);
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

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 51 operations.
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
    let t2 = t1 * cos_cylinder_phi;
    let t3 = p.spring_stiffness * (slide - p.spring_free_length);
    let t4 = t3 * cos_cylinder_phi;
    let cylinder_x_forcing = t2 + t4;
    let t5 = t3 * sin_cylinder_phi;
    let t6 = t1 * sin_cylinder_phi;
    let cylinder_y_forcing = t6 - (R::literal(2.943) - t5);
    let cylinder_phi_forcing = (-(t3 * t0)).sub_product(t1, t0);
    let rod_x_forcing = -t2 - t4;
    let rod_y_forcing = -t6 - (R::literal(1.962) + t5);
    let bobbin_x_forcing = -(p.winding_force * bobbin_y_minus_drum_y / between);
    let bobbin_y_forcing = (p.winding_force * bobbin_x_minus_drum_x / between)
        .sub_product(R::literal(9.81), p.bobbin_mass);
    [R::literal(0.0), R::literal(-7.848), R::literal(0.0), R::literal(0.0), R::literal(-11.772),
        plate_phi_forcing, cylinder_x_forcing, cylinder_y_forcing, cylinder_phi_forcing,
        rod_x_forcing, rod_y_forcing, R::literal(0.0), bobbin_x_forcing, bobbin_y_forcing,
        R::literal(0.0), R::literal(0.0), R::literal(-14.715), R::literal(0.0)]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 7660 operations.
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
    let t10 = R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * sin_plate_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi).add_product(rod_y_minus_cylinder_y,
        sin_cylinder_phi);
    let t12 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t13 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t14 = t13 - t12;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi).add_product(cylinder_omega,
        t14).add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let t15 = (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi);
    let t16 = t11 + t10;
    let t17 = t9 - t8;
    let t18 = t8 - t9;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t19 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t20 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t21 = t15 * R::literal(370.370_370_370_370_3);
    let t22 = R::literal(24.0) * sin_plate_phi;
    let t23 = R::literal(24.0) * cos_plate_phi;
    let t24 = t16 * R::literal(400.0);
    let t25 = t18 * R::literal(400.0);
    let t26 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t27 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t28 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t29 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t30 = slide * R::literal(2_777.777_777_777_778);
    let t31 = sin_cylinder_phi * R::literal(5.0);
    let t32 = cos_cylinder_phi * R::literal(5.0);
    let t33 = R::literal(250.0) * sin_rod_phi;
    let t34 = R::literal(250.0) * cos_rod_phi;
    let t35 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t36 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t37 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t38 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t39 = t19 * t1;
    let t40 = R::literal(-1.25) - t39;
    let t41 = R::literal(1.0) / t40;
    let t42 = t20 * t1;
    let t43 = t42 * t41;
    let t44 = R::literal(1.25) - t39;
    let t45 = t44 * t41;
    let t46 = t21 * t1;
    let t47 = t46 * t41;
    let t48 = t20 * t0;
    let t49 = R::literal(-1.25) - t48;
    let t50 = t43 * t42;
    let t51 = R::literal(1.0) / (t49 - t50);
    let t52 = (t19 * t0).sub_product(t45, t42);
    let t53 = t52 * t51;
    let t54 = R::literal(1.25) - t48 - t50;
    let t55 = t54 * t51;
    let t56 = (t21 * t0).add_product(t47, t42);
    let t57 = t56 * t51;
    let t58 = t22 * t3;
    let t59 = R::literal(1.0) / (t40 - R::literal(0.833_333_333_333_333_4) - t58).sub_product(t45,
        t44).sub_product(t53, t52);
    let t60 = t23 * t3;
    let t61 = (t42 + t60).sub_product(t43, t44).sub_product(t55, t52);
    let t62 = t61 * t59;
    let t63 = R::literal(0.833_333_333_333_333_4) - t58;
    let t64 = t63 * t59;
    let t65 = t60 * t59;
    let t66 = t24 * t3;
    let t67 = R::literal(0.833_333_333_333_333_4) + t66;
    let t68 = t67 * t59;
    let t69 = t25 * t3;
    let t70 = t69 * t59;
    let t71 = (-t46).add_product(t47, t44).sub_product(t57, t52);
    let t72 = t71 * t59;
    let t73 = t23 * t2;
    let t74 = R::literal(1.0) / (t49 - R::literal(0.833_333_333_333_333_4) - t73 - t50)
        .sub_product(t55, t54).sub_product(t62, t61);
    let t75 = (t22 * t2).sub_product(t64, t61);
    let t76 = t75 * t74;
    let t77 = (R::literal(0.833_333_333_333_333_4) - t73).sub_product(t65, t61);
    let t78 = t77 * t74;
    let t79 = -(t24 * t2);
    let t80 = t79.sub_product(t68, t61);
    let t81 = t80 * t74;
    let t82 = t25 * t2;
    let t83 = (R::literal(0.833_333_333_333_333_4) + t82).add_product(t70, t61);
    let t84 = t83 * t74;
    let t85 = t56.sub_product(t57, t54).sub_product(t72, t61);
    let t86 = t85 * t74;
    let t87 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t58
        - R::literal(3.333_333_333_333_333_5)).sub_product(t28, t5).sub_product(t64, t63)
        .sub_product(t76, t75);
    let t88 = t60.add_product(t29, t5).sub_product(t65, t63).sub_product(t78, t75);
    let t89 = t88 * t87;
    let t90 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t91 = t90 * t87;
    let t92 = (-t26).add_product(t30, t5);
    let t93 = t92 * t87;
    let t94 = (R::literal(-0.833_333_333_333_333_4) + t66).sub_product(t68, t63).sub_product(t81,
        t75);
    let t95 = t94 * t87;
    let t96 = (-t69).add_product(t70, t63).sub_product(t84, t75);
    let t97 = t96 * t87;
    let t98 = (-(t72 * t63)).sub_product(t86, t75);
    let t99 = t98 * t87;
    let t100 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t73
        - R::literal(3.333_333_333_333_333_5)).sub_product(t29, t4).sub_product(t65, t60)
        .sub_product(t78, t77).sub_product(t89, t88);
    let t101 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).add_product(t91, t88);
    let t102 = t101 * t100;
    let t103 = t27.sub_product(t30, t4).sub_product(t93, t88);
    let t104 = t103 * t100;
    let t105 = t79.sub_product(t68, t60).sub_product(t81, t77).sub_product(t95, t88);
    let t106 = t105 * t100;
    let t107 = (R::literal(-0.833_333_333_333_333_4) + t82).add_product(t70, t60).sub_product(t84,
        t77).sub_product(t97, t88);
    let t108 = t107 * t100;
    let t109 = (-(t72 * t60)).sub_product(t86, t77).sub_product(t99, t88);
    let t110 = t109 * t100;
    let t111 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).sub_product(t91, t90)
        .sub_product(t102, t101);
    let t112 = (-t30).add_product(t93, t90).sub_product(t104, t101);
    let t113 = t112 * t111;
    let t114 = t33 * t111;
    let t115 = t34 * t111;
    let t116 = (t95 * t90).sub_product(t106, t101);
    let t117 = t116 * t111;
    let t118 = (t97 * t90).sub_product(t108, t101);
    let t119 = t118 * t111;
    let t120 = (t99 * t90).sub_product(t110, t101);
    let t121 = t120 * t111;
    let t122 = R::literal(1.0) / (-(t27 * cos_cylinder_phi)).sub_product(t26, sin_cylinder_phi)
        .sub_product(t30, slide).sub_product(t31, sin_cylinder_phi).sub_product(t32,
        cos_cylinder_phi).sub_product(t93, t92).sub_product(t104, t103).sub_product(t113, t112);
    let t123 = t31.sub_product(t114, t112);
    let t124 = t123 * t122;
    let t125 = (-t32).add_product(t115, t112);
    let t126 = t125 * t122;
    let t127 = (-(t95 * t92)).sub_product(t106, t103).sub_product(t117, t112);
    let t128 = t127 * t122;
    let t129 = (-(t97 * t92)).sub_product(t108, t103).sub_product(t119, t112);
    let t130 = t129 * t122;
    let t131 = (-(t99 * t92)).sub_product(t110, t103).sub_product(t121, t112);
    let t132 = t131 * t122;
    let t133 = R::literal(1.0) / R::literal(-5.0).sub_product(t33, t7).sub_product(t114, t33)
        .sub_product(t124, t123);
    let t134 = (t34 * t7).add_product(t115, t33).sub_product(t126, t123);
    let t135 = t134 * t133;
    let t136 = (-(t117 * t33)).sub_product(t128, t123);
    let t137 = t136 * t133;
    let t138 = (-(t119 * t33)).sub_product(t130, t123);
    let t139 = t138 * t133;
    let t140 = (-(t121 * t33)).sub_product(t132, t123);
    let t141 = t140 * t133;
    let t142 = R::literal(1.0) / R::literal(-5.0).sub_product(t34, t6).sub_product(t115, t34)
        .sub_product(t126, t125).sub_product(t135, t134);
    let t143 = (t117 * t34).sub_product(t128, t125).sub_product(t137, t134);
    let t144 = t143 * t142;
    let t145 = (t119 * t34).sub_product(t130, t125).sub_product(t139, t134);
    let t146 = t145 * t142;
    let t147 = (t121 * t34).sub_product(t132, t125).sub_product(t141, t134);
    let t148 = t147 * t142;
    let t149 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t24, t16)
        - c.inverse_bobbin_mass).sub_product(t68, t67).sub_product(t81, t80).sub_product(t95, t94)
        .sub_product(t106, t105).sub_product(t117, t116).sub_product(t128, t127).sub_product(t137,
        t136).sub_product(t144, t143);
    let t150 = (t25 * t16).add_product(t70, t67).sub_product(t84, t80).sub_product(t97, t94)
        .sub_product(t108, t105).sub_product(t119, t116).sub_product(t130, t127).sub_product(t139,
        t136).sub_product(t146, t143);
    let t151 = t150 * t149;
    let t152 = t35 * t149;
    let t153 = (-(t72 * t67)).sub_product(t86, t80).sub_product(t99, t94).sub_product(t110, t105)
        .sub_product(t121, t116).sub_product(t132, t127).sub_product(t141, t136).sub_product(t148,
        t143);
    let t154 = t153 * t149;
    let t155 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t25, t18)
        - c.inverse_bobbin_mass).sub_product(t70, t69).sub_product(t84, t83).sub_product(t97, t96)
        .sub_product(t108, t107).sub_product(t119, t118).sub_product(t130, t129).sub_product(t139,
        t138).sub_product(t146, t145).sub_product(t151, t150);
    let t156 = (-t36).add_product(t152, t150);
    let t157 = t156 * t155;
    let t158 = (t72 * t69).sub_product(t86, t83).sub_product(t99, t96).sub_product(t110, t107)
        .sub_product(t121, t118).sub_product(t132, t129).sub_product(t141, t138).sub_product(t148,
        t145).sub_product(t154, t150);
    let t159 = t158 * t155;
    let t160 = t37 * bobbin_x_minus_drum_x_over_between;
    let t161 = t38 * bobbin_y_minus_drum_y_over_between;
    let t162 = R::literal(1.0) / (((-(t36 * bobbin_y_minus_drum_y_over_between)).sub_product(t35,
        bobbin_x_minus_drum_x_over_between) - t160 - t161).sub_product(t152, t35).sub_product(t157,
        t156) + t160 + t161);
    let t163 = (t154 * t35).sub_product(t159, t156);
    let t164 = t163 * t162;
    let t165 = R::literal(1.0) / (-(t21 * t15)).sub_product(t47, t46).sub_product(t57, t56)
        .sub_product(t72, t71).sub_product(t86, t85).sub_product(t99, t98).sub_product(t110, t109)
        .sub_product(t121, t120).sub_product(t132, t131).sub_product(t141, t140).sub_product(t148,
        t147).sub_product(t154, t153).sub_product(t159, t158).sub_product(t164, t163);
    let t166 = R::literal(50.0) * slide_rate;
    let t167 = t166 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t168 = p.spring_stiffness * slide_minus_spring_free_length;
    let t169 = t168 * cos_cylinder_phi;
    let t170 = t167 + t169;
    let t171 = t168 * sin_cylinder_phi;
    let t172 = t166 * sin_cylinder_phi;
    let t173 = t172 - (R::literal(2.943) - t171);
    let t174 = (-(t168 * t14)).sub_product(t166, t14);
    let t175 = -t167;
    let t176 = t175 - t169;
    let t177 = -t172 - (R::literal(1.962) + t171);
    let t178 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t179 = p.winding_force * bobbin_x_minus_drum_x;
    let t180 = t179 / between - c.t0;
    let post_omega_squared = post_omega * post_omega;
    let t181 = R::literal(0.1) * post_omega_squared;
    let t182 = t181 * cos_post_phi;
    let t183 = t181 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t184 = R::literal(0.06) * plate_omega_squared;
    let t185 = t184 * cos_plate_phi;
    let t186 = t184 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t187 = cylinder_omega_squared * cos_cylinder_phi;
    let t188 = cylinder_omega_squared * sin_cylinder_phi;
    let t189 = R::literal(2.0) * cylinder_v_x;
    let t190 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t191 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t192 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t193 = R::literal(2.0) * rod_v_x;
    let t194 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t195 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t196 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t197 = R::literal(0.06) * (rod_omega * rod_omega);
    let t198 = t197 * cos_rod_phi;
    let t199 = t197 * sin_rod_phi;
    let t200 = t18 * plate_omega_squared;
    let between_squared = between * between;
    let between_squared_times_between = between_squared * between;
    let t201 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t202 = bobbin_v_y * bobbin_x_minus_drum_x;
    let t203 = t202 * bobbin_y_minus_drum_y / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t204 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let drum_v_y_times_bobbin_x_minus_drum_x = drum_v_y * bobbin_x_minus_drum_x;
    let t205 = drum_v_y_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t206 = bobbin_v_x * bobbin_x_minus_drum_x;
    let t207 = t206 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t208 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let drum_v_x_times_bobbin_x_minus_drum_x = drum_v_x * bobbin_x_minus_drum_x;
    let t209 = drum_v_x_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t210 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t211 = (bobbin_v_x * (bobbin_v_x_over_between + t204 + t205 - t201 - t203
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t209 + t210
        - t207 - t208 - drum_v_y_over_between).add_product(drum_v_x, t201 + t203
        + drum_v_x_over_between - bobbin_v_x_over_between - t204 - t205).add_product(drum_v_y, t207
        + t208 + drum_v_y_over_between - bobbin_v_y_over_between - t209 - t210);
    let t212 = R::literal(0.044) * cos_post_phi;
    let t213 = R::literal(0.143) * sin_post_phi;
    let t214 = t43 * t182;
    let t215 = -t183 - R::literal(-9.81) + t214;
    let t216 = t22 * c.bobbin_radius_times_winding_force;
    let t217 = (t216 - (t185 + t182)).add_product(t45, t182).sub_product(t53, t215);
    let t218 = t23 * c.bobbin_radius_times_winding_force;
    let t219 = (-(t186 + t183) - R::literal(9.81) - R::literal(-9.81) - t218 + t214)
        .sub_product(t55, t215).sub_product(t62, t217);
    let t220 = R::literal(3.333_333_333_333_333_5) * t170;
    let t221 = (t216.sub_product(R::literal(0.06), t187.add_product(plate_omega_squared,
        cos_plate_phi)) - t220).sub_product(t28, t174).sub_product(t64, t217).sub_product(t76,
        t219);
    let t222 = R::literal(3.333_333_333_333_333_5) * t173;
    let t223 = (R::literal(-9.81).sub_product(R::literal(0.06), t188
        .add_product(plate_omega_squared, sin_plate_phi)) - t218 - t222).add_product(t29, t174)
        .sub_product(t65, t217).sub_product(t78, t219).sub_product(t89, t221);
    let t224 = (-(R::literal(-2_777.777_777_777_778) * t174)).add_product(t91, t221)
        .sub_product(t102, t223);
    let t225 = (cylinder_omega * (((t193 * cos_cylinder_phi).add_product(t194, sin_cylinder_phi)
        + t195 + t196).sub_product(t189, cos_cylinder_phi).sub_product(t190, sin_cylinder_phi)
        - t191 - t192)).sub_product(t26, t170).add_product(t27, t173).add_product(t30, t174)
        .add_product(t31, t176).sub_product(t32, t177).sub_product(t93, t221).sub_product(t104,
        t223).sub_product(t113, t224);
    let t226 = R::literal(5.0) * t176;
    let t227 = (t198 - t226).sub_product(t114, t224).sub_product(t124, t225);
    let t228 = R::literal(5.0) * t177;
    let t229 = (t199 - t228).add_product(t115, t224).sub_product(t126, t225).sub_product(t135,
        t227);
    let t230 = c.inverse_bobbin_mass * t178;
    let t231 = (t200.sub_product(t24, c.bobbin_radius_times_winding_force) + t230).sub_product(t68,
        t217).sub_product(t81, t219).sub_product(t95, t221).sub_product(t106, t223)
        .sub_product(t117, t224).sub_product(t128, t225).sub_product(t137, t227).sub_product(t144,
        t229);
    let t232 = c.inverse_bobbin_mass * t180;
    let t233 = (R::literal(-9.81).add_product(t16, plate_omega_squared).add_product(t25,
        c.bobbin_radius_times_winding_force) - t232).add_product(t70, t217).sub_product(t84, t219)
        .sub_product(t97, t221).sub_product(t108, t223).sub_product(t119, t224).sub_product(t130,
        t225).sub_product(t139, t227).sub_product(t146, t229).sub_product(t151, t231);
    let t234 = (-t211).add_product(t35, t178).sub_product(t36, t180)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t152, t231).sub_product(t157, t233)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t235 = ((t213 - t212) * post_omega_squared).sub_product(t47, t182).sub_product(t57, t215)
        .sub_product(t72, t217).sub_product(t86, t219).sub_product(t99, t221).sub_product(t110,
        t223).sub_product(t121, t224).sub_product(t132, t225).sub_product(t141, t227)
        .sub_product(t148, t229).sub_product(t154, t231).sub_product(t159, t233).sub_product(t164,
        t234) * t165;
    let t236 = (t234 * t162).sub_product(t164, t235);
    let t237 = (t233 * t155).sub_product(t157, t236).sub_product(t159, t235);
    let t238 = (t231 * t149).sub_product(t151, t237).add_product(t152, t236).sub_product(t154,
        t235);
    let t239 = (t229 * t142).sub_product(t144, t238).sub_product(t146, t237).sub_product(t148,
        t235);
    let t240 = (t227 * t133).sub_product(t135, t239).sub_product(t137, t238).sub_product(t139, t237)
        .sub_product(t141, t235);
    let t241 = (t225 * t122).sub_product(t124, t240).sub_product(t126, t239).sub_product(t128, t238)
        .sub_product(t130, t237).sub_product(t132, t235);
    let t242 = (t224 * t111).sub_product(t113, t241).sub_product(t114, t240).add_product(t115, t239)
        .sub_product(t117, t238).sub_product(t119, t237).sub_product(t121, t235);
    let t243 = (t223 * t100).sub_product(t102, t242).sub_product(t104, t241).sub_product(t106, t238)
        .sub_product(t108, t237).sub_product(t110, t235);
    let t244 = (t221 * t87).sub_product(t89, t243).add_product(t91, t242).sub_product(t93, t241)
        .sub_product(t95, t238).sub_product(t97, t237).sub_product(t99, t235);
    let t245 = (t219 * t74).sub_product(t76, t244).sub_product(t78, t243).sub_product(t81, t238)
        .sub_product(t84, t237).sub_product(t86, t235);
    let t246 = (t217 * t59).sub_product(t62, t245).sub_product(t64, t244).sub_product(t65, t243)
        .sub_product(t68, t238).add_product(t70, t237).sub_product(t72, t235);
    let t247 = (t215 * t51).sub_product(t53, t246).sub_product(t55, t245).sub_product(t57, t235);
    let t248 = (-(t182 * t41)).sub_product(t43, t247).sub_product(t45, t246).sub_product(t43, t245)
        .add_product(t47, t235);
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        .sub_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t236)).add_product(t38, t236);
    let drum_v_x_dot = (t37 * t236).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t236);
    let bobbin_v_y_dot = t232.sub_product(c.inverse_bobbin_mass, t237).sub_product(t36, t236);
    let bobbin_v_x_dot = (-t230).sub_product(c.inverse_bobbin_mass, t238).sub_product(t35, t236);
    let rod_omega_dot = (t33 * t240).sub_product(R::literal(4_166.666_666_666_667), t242)
        .sub_product(t34, t239);
    let rod_v_y_dot = t228.sub_product(t32, t241).sub_product(R::literal(5.0), t239);
    let rod_v_x_dot = t226.add_product(t31, t241).sub_product(R::literal(5.0), t240);
    let cylinder_omega_dot = (t174 * R::literal(2_777.777_777_777_778)).sub_product(t28, t244)
        .add_product(t29, t243).sub_product(R::literal(-2_777.777_777_777_778), t242)
        .add_product(t30, t241);
    let cylinder_v_y_dot = t222.sub_product(R::literal(3.333_333_333_333_333_5), t243)
        .add_product(t27, t241);
    let cylinder_v_x_dot = t220.sub_product(R::literal(3.333_333_333_333_333_5), t244)
        .sub_product(t26, t241);
    let plate_omega_dot = c.t1.sub_product(t22, t246).add_product(t23, t245).sub_product(t22, t244)
        .add_product(t23, t243).add_product(t24, t238).sub_product(t25, t237);
    let post_omega_dot = (t20 * t247).sub_product(t19, t248).sub_product(t19, t246)
        .add_product(t20, t245).sub_product(t21, t235);
    let t249 = t212 - t213;
    let t250 = (-(t1 * t247)).sub_product(t0, t248).sub_product(t0, t246).sub_product(t1, t245)
        .sub_product(t249, t235);
    let t251 = t183.sub_product(t0, post_omega_dot).sub_product(t19, t250);
    let t252 = (-t182).sub_product(t1, post_omega_dot).add_product(t20, t250).sub_product(t43,
        t251);
    let t253 = t251.sub_product(t45, t251).sub_product(t53, t252);
    let t254 = t252.sub_product(t55, t252).sub_product(t62, t253);
    let t255 = (-(t64 * t253)).sub_product(t76, t254);
    let t256 = (-(t65 * t253)).sub_product(t78, t254).sub_product(t89, t255);
    let t257 = (t91 * t255).sub_product(t102, t256);
    let t258 = (-(t93 * t255)).sub_product(t104, t256).sub_product(t113, t257);
    let t259 = (-(t114 * t257)).sub_product(t124, t258);
    let t260 = (t115 * t257).sub_product(t126, t258).sub_product(t135, t259);
    let t261 = (-(t68 * t253)).sub_product(t81, t254).sub_product(t95, t255).sub_product(t106, t256)
        .sub_product(t117, t257).sub_product(t128, t258).sub_product(t137, t259).sub_product(t144,
        t260);
    let t262 = (t70 * t253).sub_product(t84, t254).sub_product(t97, t255).sub_product(t108, t256)
        .sub_product(t119, t257).sub_product(t130, t258).sub_product(t139, t259).sub_product(t146,
        t260).sub_product(t151, t261);
    let t263 = (t152 * t261).sub_product(t157, t262);
    let t264 = (t15 * post_omega_squared).sub_product(t249, post_omega_dot).sub_product(t21, t250)
        .add_product(t47, t251).sub_product(t57, t252).sub_product(t72, t253).sub_product(t86, t254)
        .sub_product(t99, t255).sub_product(t110, t256).sub_product(t121, t257).sub_product(t132,
        t258).sub_product(t141, t259).sub_product(t148, t260).sub_product(t154, t261)
        .sub_product(t159, t262).sub_product(t164, t263) * t165;
    let t265 = (t263 * t162).sub_product(t164, t264);
    let t266 = (t262 * t155).sub_product(t157, t265).sub_product(t159, t264);
    let t267 = (t261 * t149).sub_product(t151, t266).add_product(t152, t265).sub_product(t154,
        t264);
    let t268 = (t260 * t142).sub_product(t144, t267).sub_product(t146, t266).sub_product(t148,
        t264);
    let t269 = (t259 * t133).sub_product(t135, t268).sub_product(t137, t267).sub_product(t139, t266)
        .sub_product(t141, t264);
    let t270 = (t258 * t122).sub_product(t124, t269).sub_product(t126, t268).sub_product(t128, t267)
        .sub_product(t130, t266).sub_product(t132, t264);
    let t271 = (t257 * t111).sub_product(t113, t270).sub_product(t114, t269).add_product(t115, t268)
        .sub_product(t117, t267).sub_product(t119, t266).sub_product(t121, t264);
    let t272 = (t256 * t100).sub_product(t102, t271).sub_product(t104, t270).sub_product(t106, t267)
        .sub_product(t108, t266).sub_product(t110, t264);
    let t273 = (t255 * t87).sub_product(t89, t272).add_product(t91, t271).sub_product(t93, t270)
        .sub_product(t95, t267).sub_product(t97, t266).sub_product(t99, t264);
    let t274 = (t254 * t74).sub_product(t76, t273).sub_product(t78, t272).sub_product(t81, t267)
        .sub_product(t84, t266).sub_product(t86, t264);
    let t275 = (t253 * t59).sub_product(t62, t274).sub_product(t64, t273).sub_product(t65, t272)
        .sub_product(t68, t267).add_product(t70, t266).sub_product(t72, t264);
    let t276 = (t252 * t51).sub_product(t53, t275).sub_product(t55, t274).sub_product(t57, t264);
    let t277 = (t251 * t41).sub_product(t43, t276).sub_product(t45, t275).sub_product(t43, t274)
        .add_product(t47, t264);
    let drum_v_y_dot_by_post_phi = (t38 * t265).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t265);
    let drum_v_x_dot_by_post_phi = (t37 * t265).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t265);
    let bobbin_v_y_dot_by_post_phi = (-(t36 * t265)).sub_product(c.inverse_bobbin_mass, t266);
    let bobbin_v_x_dot_by_post_phi = (-(t35 * t265)).sub_product(c.inverse_bobbin_mass, t267);
    let rod_omega_dot_by_post_phi = (t33 * t269).sub_product(R::literal(4_166.666_666_666_667),
        t271).sub_product(t34, t268);
    let rod_v_y_dot_by_post_phi = (-(R::literal(5.0) * t268)).sub_product(t32, t270);
    let rod_v_x_dot_by_post_phi = (-(R::literal(5.0) * t269)).add_product(t31, t270);
    let cylinder_omega_dot_by_post_phi = (t29 * t272).sub_product(t28, t273)
        .sub_product(R::literal(-2_777.777_777_777_778), t271).add_product(t30, t270);
    let cylinder_v_y_dot_by_post_phi = (t27 * t270)
        .sub_product(R::literal(3.333_333_333_333_333_5), t272);
    let cylinder_v_x_dot_by_post_phi = (-(t26 * t270))
        .sub_product(R::literal(3.333_333_333_333_333_5), t273);
    let plate_omega_dot_by_post_phi = (t23 * t274).sub_product(t22, t275).sub_product(t22, t273)
        .add_product(t23, t272).add_product(t24, t267).sub_product(t25, t266);
    let plate_v_y_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t272))
        .sub_product(R::literal(0.833_333_333_333_333_4), t274)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t266);
    let plate_v_x_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t273))
        .sub_product(R::literal(0.833_333_333_333_333_4), t275)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t267);
    let post_omega_dot_by_post_phi = (t250 * R::literal(370.370_370_370_370_3)).sub_product(t19,
        t277).add_product(t20, t276).sub_product(t19, t275).add_product(t20, t274).sub_product(t21,
        t264);
    let post_v_y_dot_by_post_phi = (-(R::literal(-1.25) * t274)).sub_product(R::literal(1.25),
        t276);
    let post_v_x_dot_by_post_phi = (-(R::literal(-1.25) * t275)).sub_product(R::literal(1.25),
        t277);
    let t278 = (-(t3 * t245)).sub_product(t2, t246).sub_product(t2, t244).sub_product(t3, t243)
        .sub_product(t17, t238).add_product(t16, t237);
    let t279 = t186.sub_product(t2, plate_omega_dot).sub_product(t22, t278);
    let t280 = (-t185).sub_product(t3, plate_omega_dot).add_product(t23, t278);
    let t281 = t280.sub_product(t62, t279);
    let t282 = t279.sub_product(t64, t279).sub_product(t76, t281);
    let t283 = t280.sub_product(t65, t279).sub_product(t78, t281).sub_product(t89, t282);
    let t284 = (t91 * t282).sub_product(t102, t283);
    let t285 = (-(t93 * t282)).sub_product(t104, t283).sub_product(t113, t284);
    let t286 = (-(t114 * t284)).sub_product(t124, t285);
    let t287 = (t115 * t284).sub_product(t126, t285).sub_product(t135, t286);
    let t288 = ((-t10 - t11) * plate_omega_squared).sub_product(t17, plate_omega_dot)
        .add_product(t24, t278).sub_product(t68, t279).sub_product(t81, t281).sub_product(t95, t282)
        .sub_product(t106, t283).sub_product(t117, t284).sub_product(t128, t285).sub_product(t137,
        t286).sub_product(t144, t287);
    let t289 = t200.add_product(t16, plate_omega_dot).sub_product(t25, t278).add_product(t70, t279)
        .sub_product(t84, t281).sub_product(t97, t282).sub_product(t108, t283).sub_product(t119,
        t284).sub_product(t130, t285).sub_product(t139, t286).sub_product(t146, t287)
        .sub_product(t151, t288);
    let t290 = (t152 * t288).sub_product(t157, t289);
    let t291 = (-(t72 * t279)).sub_product(t86, t281).sub_product(t99, t282).sub_product(t110, t283)
        .sub_product(t121, t284).sub_product(t132, t285).sub_product(t141, t286).sub_product(t148,
        t287).sub_product(t154, t288).sub_product(t159, t289).sub_product(t164, t290) * t165;
    let t292 = (t290 * t162).sub_product(t164, t291);
    let t293 = (t289 * t155).sub_product(t157, t292).sub_product(t159, t291);
    let t294 = (t288 * t149).sub_product(t151, t293).add_product(t152, t292).sub_product(t154,
        t291);
    let t295 = (t287 * t142).sub_product(t144, t294).sub_product(t146, t293).sub_product(t148,
        t291);
    let t296 = (t286 * t133).sub_product(t135, t295).sub_product(t137, t294).sub_product(t139, t293)
        .sub_product(t141, t291);
    let t297 = (t285 * t122).sub_product(t124, t296).sub_product(t126, t295).sub_product(t128, t294)
        .sub_product(t130, t293).sub_product(t132, t291);
    let t298 = (t284 * t111).sub_product(t113, t297).sub_product(t114, t296).add_product(t115, t295)
        .sub_product(t117, t294).sub_product(t119, t293).sub_product(t121, t291);
    let t299 = (t283 * t100).sub_product(t102, t298).sub_product(t104, t297).sub_product(t106, t294)
        .sub_product(t108, t293).sub_product(t110, t291);
    let t300 = (t282 * t87).sub_product(t89, t299).add_product(t91, t298).sub_product(t93, t297)
        .sub_product(t95, t294).sub_product(t97, t293).sub_product(t99, t291);
    let t301 = (t281 * t74).sub_product(t76, t300).sub_product(t78, t299).sub_product(t81, t294)
        .sub_product(t84, t293).sub_product(t86, t291);
    let t302 = (t279 * t59).sub_product(t62, t301).sub_product(t64, t300).sub_product(t65, t299)
        .sub_product(t68, t294).add_product(t70, t293).sub_product(t72, t291);
    let t303 = (-(t55 * t301)).sub_product(t53, t302).sub_product(t57, t291);
    let t304 = (-(t45 * t302)).sub_product(t43, t303).sub_product(t43, t301).add_product(t47, t291);
    let drum_v_y_dot_by_plate_phi = (t38 * t292).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t292);
    let drum_v_x_dot_by_plate_phi = (t37 * t292).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t292);
    let bobbin_v_y_dot_by_plate_phi = (-(t36 * t292)).sub_product(c.inverse_bobbin_mass, t293);
    let bobbin_v_x_dot_by_plate_phi = (-(t35 * t292)).sub_product(c.inverse_bobbin_mass, t294);
    let rod_omega_dot_by_plate_phi = (t33 * t296).sub_product(R::literal(4_166.666_666_666_667),
        t298).sub_product(t34, t295);
    let rod_v_y_dot_by_plate_phi = (-(R::literal(5.0) * t295)).sub_product(t32, t297);
    let rod_v_x_dot_by_plate_phi = (-(R::literal(5.0) * t296)).add_product(t31, t297);
    let cylinder_omega_dot_by_plate_phi = (t29 * t299).sub_product(t28, t300)
        .sub_product(R::literal(-2_777.777_777_777_778), t298).add_product(t30, t297);
    let cylinder_v_y_dot_by_plate_phi = (t27 * t297)
        .sub_product(R::literal(3.333_333_333_333_333_5), t299);
    let cylinder_v_x_dot_by_plate_phi = (-(t26 * t297))
        .sub_product(R::literal(3.333_333_333_333_333_5), t300);
    let plate_omega_dot_by_plate_phi = (t278 * R::literal(400.0)).sub_product(t22, t302)
        .add_product(t23, t301).sub_product(t22, t300).add_product(t23, t299).add_product(t24, t294)
        .sub_product(t25, t293);
    let plate_v_y_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t299))
        .sub_product(R::literal(0.833_333_333_333_333_4), t301)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t293);
    let plate_v_x_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t300))
        .sub_product(R::literal(0.833_333_333_333_333_4), t302)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t294);
    let post_omega_dot_by_plate_phi = (t20 * t303).sub_product(t19, t304).sub_product(t19, t302)
        .add_product(t20, t301).sub_product(t21, t291);
    let post_v_y_dot_by_plate_phi = (-(R::literal(-1.25) * t301)).sub_product(R::literal(1.25),
        t303);
    let post_v_x_dot_by_plate_phi = (-(R::literal(-1.25) * t302)).sub_product(R::literal(1.25),
        t304);
    let t305 = p.spring_stiffness * cos_cylinder_phi;
    let t306 = R::literal(50.0) * cylinder_omega;
    let t307 = t306 * sin_cylinder_phi;
    let t308 = t307 - t305;
    let t309 = t308 * cos_cylinder_phi;
    let t310 = t308 * sin_cylinder_phi;
    let t311 = t306 * t14;
    let t312 = t311 * sin_cylinder_phi;
    let t313 = p.spring_stiffness * t14;
    let t314 = t313 * cos_cylinder_phi;
    let t315 = t305 - t307;
    let t316 = t315 * cos_cylinder_phi;
    let t317 = t315 * sin_cylinder_phi;
    let t318 = cos_cylinder_phi * t241;
    let t319 = t314 - t312 - t172 - t171 - t318;
    let t320 = cos_cylinder_phi * cylinder_omega_dot;
    let t321 = R::literal(3.333_333_333_333_333_5) * t309;
    let t322 = (-t321).sub_product(t28, t319);
    let t323 = R::literal(3.333_333_333_333_333_5) * t310;
    let t324 = (-t323).add_product(t29, t319).sub_product(t89, t322);
    let t325 = (-(R::literal(-2_777.777_777_777_778) * t319)).add_product(t91, t322)
        .sub_product(t102, t324);
    let t326 = (t188 - t320).sub_product(t26, t309).add_product(t27, t310).add_product(t30, t319)
        .add_product(t31, t316).sub_product(t32, t317).sub_product(t93, t322).sub_product(t104,
        t324).sub_product(t113, t325);
    let t327 = R::literal(5.0) * t316;
    let t328 = (-t327).sub_product(t114, t325).sub_product(t124, t326);
    let t329 = R::literal(5.0) * t317;
    let t330 = (-t329).add_product(t115, t325).sub_product(t126, t326).sub_product(t135, t328);
    let t331 = (-(t95 * t322)).sub_product(t106, t324).sub_product(t117, t325).sub_product(t128,
        t326).sub_product(t137, t328).sub_product(t144, t330);
    let t332 = (-(t97 * t322)).sub_product(t108, t324).sub_product(t119, t325).sub_product(t130,
        t326).sub_product(t139, t328).sub_product(t146, t330).sub_product(t151, t331);
    let t333 = (t152 * t331).sub_product(t157, t332);
    let t334 = (-(t99 * t322)).sub_product(t110, t324).sub_product(t121, t325).sub_product(t132,
        t326).sub_product(t141, t328).sub_product(t148, t330).sub_product(t154, t331)
        .sub_product(t159, t332).sub_product(t164, t333) * t165;
    let t335 = (t333 * t162).sub_product(t164, t334);
    let t336 = (t332 * t155).sub_product(t157, t335).sub_product(t159, t334);
    let t337 = (t331 * t149).sub_product(t151, t336).add_product(t152, t335).sub_product(t154,
        t334);
    let t338 = (t330 * t142).sub_product(t144, t337).sub_product(t146, t336).sub_product(t148,
        t334);
    let t339 = (t328 * t133).sub_product(t135, t338).sub_product(t137, t337).sub_product(t139, t336)
        .sub_product(t141, t334);
    let t340 = (t326 * t122).sub_product(t124, t339).sub_product(t126, t338).sub_product(t128, t337)
        .sub_product(t130, t336).sub_product(t132, t334);
    let t341 = (t325 * t111).sub_product(t113, t340).sub_product(t114, t339).add_product(t115, t338)
        .sub_product(t117, t337).sub_product(t119, t336).sub_product(t121, t334);
    let t342 = (t324 * t100).sub_product(t102, t341).sub_product(t104, t340).sub_product(t106, t337)
        .sub_product(t108, t336).sub_product(t110, t334);
    let t343 = (t322 * t87).sub_product(t89, t342).add_product(t91, t341).sub_product(t93, t340)
        .sub_product(t95, t337).sub_product(t97, t336).sub_product(t99, t334);
    let t344 = (-(t78 * t342)).sub_product(t76, t343).sub_product(t81, t337).sub_product(t84, t336)
        .sub_product(t86, t334);
    let t345 = (-(t64 * t343)).sub_product(t62, t344).sub_product(t65, t342).sub_product(t68, t337)
        .add_product(t70, t336).sub_product(t72, t334);
    let t346 = (-(t55 * t344)).sub_product(t53, t345).sub_product(t57, t334);
    let t347 = (-(t45 * t345)).sub_product(t43, t346).sub_product(t43, t344).add_product(t47, t334);
    let drum_v_y_dot_by_cylinder_x = (t38 * t335).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t335);
    let drum_v_x_dot_by_cylinder_x = (t37 * t335).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t335);
    let bobbin_v_y_dot_by_cylinder_x = (-(t36 * t335)).sub_product(c.inverse_bobbin_mass, t336);
    let bobbin_v_x_dot_by_cylinder_x = (-(t35 * t335)).sub_product(c.inverse_bobbin_mass, t337);
    let rod_omega_dot_by_cylinder_x = (t33 * t339).sub_product(R::literal(4_166.666_666_666_667),
        t341).sub_product(t34, t338);
    let rod_v_y_dot_by_cylinder_x = t329.sub_product(t32, t340).sub_product(R::literal(5.0), t338);
    let rod_v_x_dot_by_cylinder_x = t327.add_product(t31, t340).sub_product(R::literal(5.0), t339);
    let cylinder_omega_dot_by_cylinder_x = (t319 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t343).add_product(t29, t342)
        .sub_product(R::literal(-2_777.777_777_777_778), t341).add_product(t30, t340);
    let cylinder_v_y_dot_by_cylinder_x = t323.sub_product(R::literal(3.333_333_333_333_333_5), t342)
        .add_product(t27, t340);
    let cylinder_v_x_dot_by_cylinder_x = t321.sub_product(R::literal(3.333_333_333_333_333_5), t343)
        .sub_product(t26, t340);
    let plate_omega_dot_by_cylinder_x = (t23 * t344).sub_product(t22, t345).sub_product(t22, t343)
        .add_product(t23, t342).add_product(t24, t337).sub_product(t25, t336);
    let plate_v_y_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t342))
        .sub_product(R::literal(0.833_333_333_333_333_4), t344)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t336);
    let plate_v_x_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t343))
        .sub_product(R::literal(0.833_333_333_333_333_4), t345)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t337);
    let post_omega_dot_by_cylinder_x = (t20 * t346).sub_product(t19, t347).sub_product(t19, t345)
        .add_product(t20, t344).sub_product(t21, t334);
    let post_v_y_dot_by_cylinder_x = (-(R::literal(-1.25) * t344)).sub_product(R::literal(1.25),
        t346);
    let post_v_x_dot_by_cylinder_x = (-(R::literal(-1.25) * t345)).sub_product(R::literal(1.25),
        t347);
    let t348 = t306 * cos_cylinder_phi;
    let t349 = p.spring_stiffness * sin_cylinder_phi;
    let t350 = -t348 - t349;
    let t351 = t350 * cos_cylinder_phi;
    let t352 = t350 * sin_cylinder_phi;
    let t353 = t311 * cos_cylinder_phi;
    let t354 = t313 * sin_cylinder_phi;
    let t355 = t348 + t349;
    let t356 = t355 * cos_cylinder_phi;
    let t357 = t355 * sin_cylinder_phi;
    let t358 = sin_cylinder_phi * t241;
    let t359 = t353 + t167 + t169 + t354 - t358;
    let t360 = sin_cylinder_phi * cylinder_omega_dot;
    let t361 = R::literal(3.333_333_333_333_333_5) * t351;
    let t362 = (-t361).sub_product(t28, t359);
    let t363 = R::literal(3.333_333_333_333_333_5) * t352;
    let t364 = (-t363).add_product(t29, t359).sub_product(t89, t362);
    let t365 = (-(R::literal(-2_777.777_777_777_778) * t359)).add_product(t91, t362)
        .sub_product(t102, t364);
    let t366 = (-t187 - t360).sub_product(t26, t351).add_product(t27, t352).add_product(t30, t359)
        .add_product(t31, t356).sub_product(t32, t357).sub_product(t93, t362).sub_product(t104,
        t364).sub_product(t113, t365);
    let t367 = R::literal(5.0) * t356;
    let t368 = (-t367).sub_product(t114, t365).sub_product(t124, t366);
    let t369 = R::literal(5.0) * t357;
    let t370 = (-t369).add_product(t115, t365).sub_product(t126, t366).sub_product(t135, t368);
    let t371 = (-(t95 * t362)).sub_product(t106, t364).sub_product(t117, t365).sub_product(t128,
        t366).sub_product(t137, t368).sub_product(t144, t370);
    let t372 = (-(t97 * t362)).sub_product(t108, t364).sub_product(t119, t365).sub_product(t130,
        t366).sub_product(t139, t368).sub_product(t146, t370).sub_product(t151, t371);
    let t373 = (t152 * t371).sub_product(t157, t372);
    let t374 = (-(t99 * t362)).sub_product(t110, t364).sub_product(t121, t365).sub_product(t132,
        t366).sub_product(t141, t368).sub_product(t148, t370).sub_product(t154, t371)
        .sub_product(t159, t372).sub_product(t164, t373) * t165;
    let t375 = (t373 * t162).sub_product(t164, t374);
    let t376 = (t372 * t155).sub_product(t157, t375).sub_product(t159, t374);
    let t377 = (t371 * t149).sub_product(t151, t376).add_product(t152, t375).sub_product(t154,
        t374);
    let t378 = (t370 * t142).sub_product(t144, t377).sub_product(t146, t376).sub_product(t148,
        t374);
    let t379 = (t368 * t133).sub_product(t135, t378).sub_product(t137, t377).sub_product(t139, t376)
        .sub_product(t141, t374);
    let t380 = (t366 * t122).sub_product(t124, t379).sub_product(t126, t378).sub_product(t128, t377)
        .sub_product(t130, t376).sub_product(t132, t374);
    let t381 = (t365 * t111).sub_product(t113, t380).sub_product(t114, t379).add_product(t115, t378)
        .sub_product(t117, t377).sub_product(t119, t376).sub_product(t121, t374);
    let t382 = (t364 * t100).sub_product(t102, t381).sub_product(t104, t380).sub_product(t106, t377)
        .sub_product(t108, t376).sub_product(t110, t374);
    let t383 = (t362 * t87).sub_product(t89, t382).add_product(t91, t381).sub_product(t93, t380)
        .sub_product(t95, t377).sub_product(t97, t376).sub_product(t99, t374);
    let t384 = (-(t78 * t382)).sub_product(t76, t383).sub_product(t81, t377).sub_product(t84, t376)
        .sub_product(t86, t374);
    let t385 = (-(t64 * t383)).sub_product(t62, t384).sub_product(t65, t382).sub_product(t68, t377)
        .add_product(t70, t376).sub_product(t72, t374);
    let t386 = (-(t55 * t384)).sub_product(t53, t385).sub_product(t57, t374);
    let t387 = (-(t45 * t385)).sub_product(t43, t386).sub_product(t43, t384).add_product(t47, t374);
    let drum_v_y_dot_by_cylinder_y = (t38 * t375).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t375);
    let drum_v_x_dot_by_cylinder_y = (t37 * t375).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t375);
    let bobbin_v_y_dot_by_cylinder_y = (-(t36 * t375)).sub_product(c.inverse_bobbin_mass, t376);
    let bobbin_v_x_dot_by_cylinder_y = (-(t35 * t375)).sub_product(c.inverse_bobbin_mass, t377);
    let rod_omega_dot_by_cylinder_y = (t33 * t379).sub_product(R::literal(4_166.666_666_666_667),
        t381).sub_product(t34, t378);
    let rod_v_y_dot_by_cylinder_y = t369.sub_product(t32, t380).sub_product(R::literal(5.0), t378);
    let rod_v_x_dot_by_cylinder_y = t367.add_product(t31, t380).sub_product(R::literal(5.0), t379);
    let cylinder_omega_dot_by_cylinder_y = (t359 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t383).add_product(t29, t382)
        .sub_product(R::literal(-2_777.777_777_777_778), t381).add_product(t30, t380);
    let cylinder_v_y_dot_by_cylinder_y = t363.sub_product(R::literal(3.333_333_333_333_333_5), t382)
        .add_product(t27, t380);
    let cylinder_v_x_dot_by_cylinder_y = t361.sub_product(R::literal(3.333_333_333_333_333_5), t383)
        .sub_product(t26, t380);
    let plate_omega_dot_by_cylinder_y = (t23 * t384).sub_product(t22, t385).sub_product(t22, t383)
        .add_product(t23, t382).add_product(t24, t377).sub_product(t25, t376);
    let plate_v_y_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t382))
        .sub_product(R::literal(0.833_333_333_333_333_4), t384)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t376);
    let plate_v_x_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t383))
        .sub_product(R::literal(0.833_333_333_333_333_4), t385)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t377);
    let post_omega_dot_by_cylinder_y = (t20 * t386).sub_product(t19, t387).sub_product(t19, t385)
        .add_product(t20, t384).sub_product(t21, t374);
    let post_v_y_dot_by_cylinder_y = (-(R::literal(-1.25) * t384)).sub_product(R::literal(1.25),
        t386);
    let post_v_x_dot_by_cylinder_y = (-(R::literal(-1.25) * t385)).sub_product(R::literal(1.25),
        t387);
    let t388 = R::literal(50.0) * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
        .sub_product(cylinder_omega, slide).sub_product(rod_v_x_minus_cylinder_v_x,
        sin_cylinder_phi);
    let t389 = t388 * cos_cylinder_phi;
    let t390 = t388 * sin_cylinder_phi;
    let t391 = t14 * t14;
    let t392 = R::literal(0.06) * cylinder_omega_squared;
    let t393 = t389 + t314 - t172 - t171 - t318;
    let t394 = t167 + t390 - (-t169 - t354) - t358;
    let t395 = t12 - t13;
    let t396 = (p.spring_stiffness * slide * slide_minus_spring_free_length)
        .add_product(R::literal(50.0) * slide, slide_rate).sub_product(t388, t14)
        .sub_product(p.spring_stiffness, t391).sub_product(t4, t244).sub_product(t5, t243)
        .sub_product(t395, t241);
    let t397 = t172 + t171 - t389 - t314 + t318;
    let t398 = t175 - t390 - (t169 + t354) + t358;
    let t399 = R::literal(3.333_333_333_333_333_5) * t393;
    let t400 = ((t392 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t399)
        .sub_product(t28, t396);
    let t401 = R::literal(3.333_333_333_333_333_5) * t394;
    let t402 = ((-(t392 * cos_cylinder_phi)).sub_product(t5, cylinder_omega_dot) - t401)
        .add_product(t29, t396).sub_product(t89, t400);
    let t403 = (-(R::literal(-2_777.777_777_777_778) * t396)).add_product(t91, t400)
        .sub_product(t102, t402);
    let t404 = (cylinder_omega * (t189 * sin_cylinder_phi).add_product(t194, cos_cylinder_phi)
        .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
        .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi).sub_product(t190,
        cos_cylinder_phi).sub_product(t193, sin_cylinder_phi)
        .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi)).sub_product(cos_cylinder_phi,
        cylinder_v_x_dot).sub_product(sin_cylinder_phi, cylinder_v_y_dot).sub_product(t395,
        cylinder_omega_dot).add_product(cos_cylinder_phi, rod_v_x_dot)
        .add_product(sin_cylinder_phi, rod_v_y_dot).sub_product(t26, t393).add_product(t27, t394)
        .add_product(t30, t396).add_product(t31, t397).sub_product(t32, t398).sub_product(t93, t400)
        .sub_product(t104, t402).sub_product(t113, t403);
    let t405 = R::literal(5.0) * t397;
    let t406 = (-t405).sub_product(t114, t403).sub_product(t124, t404);
    let t407 = R::literal(5.0) * t398;
    let t408 = (-t407).add_product(t115, t403).sub_product(t126, t404).sub_product(t135, t406);
    let t409 = (-(t95 * t400)).sub_product(t106, t402).sub_product(t117, t403).sub_product(t128,
        t404).sub_product(t137, t406).sub_product(t144, t408);
    let t410 = (-(t97 * t400)).sub_product(t108, t402).sub_product(t119, t403).sub_product(t130,
        t404).sub_product(t139, t406).sub_product(t146, t408).sub_product(t151, t409);
    let t411 = (t152 * t409).sub_product(t157, t410);
    let t412 = (-(t99 * t400)).sub_product(t110, t402).sub_product(t121, t403).sub_product(t132,
        t404).sub_product(t141, t406).sub_product(t148, t408).sub_product(t154, t409)
        .sub_product(t159, t410).sub_product(t164, t411) * t165;
    let t413 = (t411 * t162).sub_product(t164, t412);
    let t414 = (t410 * t155).sub_product(t157, t413).sub_product(t159, t412);
    let t415 = (t409 * t149).sub_product(t151, t414).add_product(t152, t413).sub_product(t154,
        t412);
    let t416 = (t408 * t142).sub_product(t144, t415).sub_product(t146, t414).sub_product(t148,
        t412);
    let t417 = (t406 * t133).sub_product(t135, t416).sub_product(t137, t415).sub_product(t139, t414)
        .sub_product(t141, t412);
    let t418 = (t404 * t122).sub_product(t124, t417).sub_product(t126, t416).sub_product(t128, t415)
        .sub_product(t130, t414).sub_product(t132, t412);
    let t419 = (t403 * t111).sub_product(t113, t418).sub_product(t114, t417).add_product(t115, t416)
        .sub_product(t117, t415).sub_product(t119, t414).sub_product(t121, t412);
    let t420 = (t402 * t100).sub_product(t102, t419).sub_product(t104, t418).sub_product(t106, t415)
        .sub_product(t108, t414).sub_product(t110, t412);
    let t421 = (t400 * t87).sub_product(t89, t420).add_product(t91, t419).sub_product(t93, t418)
        .sub_product(t95, t415).sub_product(t97, t414).sub_product(t99, t412);
    let t422 = (-(t78 * t420)).sub_product(t76, t421).sub_product(t81, t415).sub_product(t84, t414)
        .sub_product(t86, t412);
    let t423 = (-(t64 * t421)).sub_product(t62, t422).sub_product(t65, t420).sub_product(t68, t415)
        .add_product(t70, t414).sub_product(t72, t412);
    let t424 = (-(t55 * t422)).sub_product(t53, t423).sub_product(t57, t412);
    let t425 = (-(t45 * t423)).sub_product(t43, t424).sub_product(t43, t422).add_product(t47, t412);
    let drum_v_y_dot_by_cylinder_phi = (t38 * t413)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t413);
    let drum_v_x_dot_by_cylinder_phi = (t37 * t413)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t413);
    let bobbin_v_y_dot_by_cylinder_phi = (-(t36 * t413)).sub_product(c.inverse_bobbin_mass, t414);
    let bobbin_v_x_dot_by_cylinder_phi = (-(t35 * t413)).sub_product(c.inverse_bobbin_mass, t415);
    let rod_omega_dot_by_cylinder_phi = (t33 * t417).sub_product(R::literal(4_166.666_666_666_667),
        t419).sub_product(t34, t416);
    let rod_v_y_dot_by_cylinder_phi = t407.sub_product(t32, t418).sub_product(R::literal(5.0),
        t416);
    let rod_v_x_dot_by_cylinder_phi = t405.add_product(t31, t418).sub_product(R::literal(5.0),
        t417);
    let cylinder_omega_dot_by_cylinder_phi = (t396 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t421).add_product(t29, t420)
        .sub_product(R::literal(-2_777.777_777_777_778), t419).add_product(t30, t418);
    let cylinder_v_y_dot_by_cylinder_phi = t401.sub_product(R::literal(3.333_333_333_333_333_5),
        t420).add_product(t27, t418);
    let cylinder_v_x_dot_by_cylinder_phi = t399.sub_product(R::literal(3.333_333_333_333_333_5),
        t421).sub_product(t26, t418);
    let plate_omega_dot_by_cylinder_phi = (t23 * t422).sub_product(t22, t423).sub_product(t22, t421)
        .add_product(t23, t420).add_product(t24, t415).sub_product(t25, t414);
    let plate_v_y_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t420))
        .sub_product(R::literal(0.833_333_333_333_333_4), t422)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t414);
    let plate_v_x_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t421))
        .sub_product(R::literal(0.833_333_333_333_333_4), t423)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t415);
    let post_omega_dot_by_cylinder_phi = (t20 * t424).sub_product(t19, t425).sub_product(t19, t423)
        .add_product(t20, t422).sub_product(t21, t412);
    let post_v_y_dot_by_cylinder_phi = (-(R::literal(-1.25) * t422)).sub_product(R::literal(1.25),
        t424);
    let post_v_x_dot_by_cylinder_phi = (-(R::literal(-1.25) * t423)).sub_product(R::literal(1.25),
        t425);
    let t426 = t312 + t172 + t171 - t314 + t318;
    let t427 = R::literal(3.333_333_333_333_333_5) * t316;
    let t428 = (-t427).sub_product(t28, t426);
    let t429 = R::literal(3.333_333_333_333_333_5) * t317;
    let t430 = (-t429).add_product(t29, t426).sub_product(t89, t428);
    let t431 = (-(R::literal(-2_777.777_777_777_778) * t426)).add_product(t91, t428)
        .sub_product(t102, t430);
    let t432 = (t320 - t188).sub_product(t26, t316).add_product(t27, t317).add_product(t30, t426)
        .add_product(t31, t309).sub_product(t32, t310).sub_product(t93, t428).sub_product(t104,
        t430).sub_product(t113, t431);
    let t433 = R::literal(5.0) * t309;
    let t434 = (-t433).sub_product(t114, t431).sub_product(t124, t432);
    let t435 = R::literal(5.0) * t310;
    let t436 = (-t435).add_product(t115, t431).sub_product(t126, t432).sub_product(t135, t434);
    let t437 = (-(t95 * t428)).sub_product(t106, t430).sub_product(t117, t431).sub_product(t128,
        t432).sub_product(t137, t434).sub_product(t144, t436);
    let t438 = (-(t97 * t428)).sub_product(t108, t430).sub_product(t119, t431).sub_product(t130,
        t432).sub_product(t139, t434).sub_product(t146, t436).sub_product(t151, t437);
    let t439 = (t152 * t437).sub_product(t157, t438);
    let t440 = (-(t99 * t428)).sub_product(t110, t430).sub_product(t121, t431).sub_product(t132,
        t432).sub_product(t141, t434).sub_product(t148, t436).sub_product(t154, t437)
        .sub_product(t159, t438).sub_product(t164, t439) * t165;
    let t441 = (t439 * t162).sub_product(t164, t440);
    let t442 = (t438 * t155).sub_product(t157, t441).sub_product(t159, t440);
    let t443 = (t437 * t149).sub_product(t151, t442).add_product(t152, t441).sub_product(t154,
        t440);
    let t444 = (t436 * t142).sub_product(t144, t443).sub_product(t146, t442).sub_product(t148,
        t440);
    let t445 = (t434 * t133).sub_product(t135, t444).sub_product(t137, t443).sub_product(t139, t442)
        .sub_product(t141, t440);
    let t446 = (t432 * t122).sub_product(t124, t445).sub_product(t126, t444).sub_product(t128, t443)
        .sub_product(t130, t442).sub_product(t132, t440);
    let t447 = (t431 * t111).sub_product(t113, t446).sub_product(t114, t445).add_product(t115, t444)
        .sub_product(t117, t443).sub_product(t119, t442).sub_product(t121, t440);
    let t448 = (t430 * t100).sub_product(t102, t447).sub_product(t104, t446).sub_product(t106, t443)
        .sub_product(t108, t442).sub_product(t110, t440);
    let t449 = (t428 * t87).sub_product(t89, t448).add_product(t91, t447).sub_product(t93, t446)
        .sub_product(t95, t443).sub_product(t97, t442).sub_product(t99, t440);
    let t450 = (-(t78 * t448)).sub_product(t76, t449).sub_product(t81, t443).sub_product(t84, t442)
        .sub_product(t86, t440);
    let t451 = (-(t64 * t449)).sub_product(t62, t450).sub_product(t65, t448).sub_product(t68, t443)
        .add_product(t70, t442).sub_product(t72, t440);
    let t452 = (-(t55 * t450)).sub_product(t53, t451).sub_product(t57, t440);
    let t453 = (-(t45 * t451)).sub_product(t43, t452).sub_product(t43, t450).add_product(t47, t440);
    let drum_v_y_dot_by_rod_x = (t38 * t441).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t441);
    let drum_v_x_dot_by_rod_x = (t37 * t441).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t441);
    let bobbin_v_y_dot_by_rod_x = (-(t36 * t441)).sub_product(c.inverse_bobbin_mass, t442);
    let bobbin_v_x_dot_by_rod_x = (-(t35 * t441)).sub_product(c.inverse_bobbin_mass, t443);
    let rod_omega_dot_by_rod_x = (t33 * t445).sub_product(R::literal(4_166.666_666_666_667), t447)
        .sub_product(t34, t444);
    let rod_v_y_dot_by_rod_x = t435.sub_product(t32, t446).sub_product(R::literal(5.0), t444);
    let rod_v_x_dot_by_rod_x = t433.add_product(t31, t446).sub_product(R::literal(5.0), t445);
    let cylinder_omega_dot_by_rod_x = (t426 * R::literal(2_777.777_777_777_778)).sub_product(t28,
        t449).add_product(t29, t448).sub_product(R::literal(-2_777.777_777_777_778), t447)
        .add_product(t30, t446);
    let cylinder_v_y_dot_by_rod_x = t429.sub_product(R::literal(3.333_333_333_333_333_5), t448)
        .add_product(t27, t446);
    let cylinder_v_x_dot_by_rod_x = t427.sub_product(R::literal(3.333_333_333_333_333_5), t449)
        .sub_product(t26, t446);
    let plate_omega_dot_by_rod_x = (t23 * t450).sub_product(t22, t451).sub_product(t22, t449)
        .add_product(t23, t448).add_product(t24, t443).sub_product(t25, t442);
    let plate_v_y_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t448))
        .sub_product(R::literal(0.833_333_333_333_333_4), t450)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t442);
    let plate_v_x_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t449))
        .sub_product(R::literal(0.833_333_333_333_333_4), t451)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t443);
    let post_omega_dot_by_rod_x = (t20 * t452).sub_product(t19, t453).sub_product(t19, t451)
        .add_product(t20, t450).sub_product(t21, t440);
    let post_v_y_dot_by_rod_x = (-(R::literal(-1.25) * t450)).sub_product(R::literal(1.25), t452);
    let post_v_x_dot_by_rod_x = (-(R::literal(-1.25) * t451)).sub_product(R::literal(1.25), t453);
    let t454 = -t353 - t167 - t169 - t354 + t358;
    let t455 = R::literal(3.333_333_333_333_333_5) * t356;
    let t456 = (-t455).sub_product(t28, t454);
    let t457 = R::literal(3.333_333_333_333_333_5) * t357;
    let t458 = (-t457).add_product(t29, t454).sub_product(t89, t456);
    let t459 = (-(R::literal(-2_777.777_777_777_778) * t454)).add_product(t91, t456)
        .sub_product(t102, t458);
    let t460 = (t187 + t360).sub_product(t26, t356).add_product(t27, t357).add_product(t30, t454)
        .add_product(t31, t351).sub_product(t32, t352).sub_product(t93, t456).sub_product(t104,
        t458).sub_product(t113, t459);
    let t461 = R::literal(5.0) * t351;
    let t462 = (-t461).sub_product(t114, t459).sub_product(t124, t460);
    let t463 = R::literal(5.0) * t352;
    let t464 = (-t463).add_product(t115, t459).sub_product(t126, t460).sub_product(t135, t462);
    let t465 = (-(t95 * t456)).sub_product(t106, t458).sub_product(t117, t459).sub_product(t128,
        t460).sub_product(t137, t462).sub_product(t144, t464);
    let t466 = (-(t97 * t456)).sub_product(t108, t458).sub_product(t119, t459).sub_product(t130,
        t460).sub_product(t139, t462).sub_product(t146, t464).sub_product(t151, t465);
    let t467 = (t152 * t465).sub_product(t157, t466);
    let t468 = (-(t99 * t456)).sub_product(t110, t458).sub_product(t121, t459).sub_product(t132,
        t460).sub_product(t141, t462).sub_product(t148, t464).sub_product(t154, t465)
        .sub_product(t159, t466).sub_product(t164, t467) * t165;
    let t469 = (t467 * t162).sub_product(t164, t468);
    let t470 = (t466 * t155).sub_product(t157, t469).sub_product(t159, t468);
    let t471 = (t465 * t149).sub_product(t151, t470).add_product(t152, t469).sub_product(t154,
        t468);
    let t472 = (t464 * t142).sub_product(t144, t471).sub_product(t146, t470).sub_product(t148,
        t468);
    let t473 = (t462 * t133).sub_product(t135, t472).sub_product(t137, t471).sub_product(t139, t470)
        .sub_product(t141, t468);
    let t474 = (t460 * t122).sub_product(t124, t473).sub_product(t126, t472).sub_product(t128, t471)
        .sub_product(t130, t470).sub_product(t132, t468);
    let t475 = (t459 * t111).sub_product(t113, t474).sub_product(t114, t473).add_product(t115, t472)
        .sub_product(t117, t471).sub_product(t119, t470).sub_product(t121, t468);
    let t476 = (t458 * t100).sub_product(t102, t475).sub_product(t104, t474).sub_product(t106, t471)
        .sub_product(t108, t470).sub_product(t110, t468);
    let t477 = (t456 * t87).sub_product(t89, t476).add_product(t91, t475).sub_product(t93, t474)
        .sub_product(t95, t471).sub_product(t97, t470).sub_product(t99, t468);
    let t478 = (-(t78 * t476)).sub_product(t76, t477).sub_product(t81, t471).sub_product(t84, t470)
        .sub_product(t86, t468);
    let t479 = (-(t64 * t477)).sub_product(t62, t478).sub_product(t65, t476).sub_product(t68, t471)
        .add_product(t70, t470).sub_product(t72, t468);
    let t480 = (-(t55 * t478)).sub_product(t53, t479).sub_product(t57, t468);
    let t481 = (-(t45 * t479)).sub_product(t43, t480).sub_product(t43, t478).add_product(t47, t468);
    let drum_v_y_dot_by_rod_y = (t38 * t469).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t469);
    let drum_v_x_dot_by_rod_y = (t37 * t469).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t469);
    let bobbin_v_y_dot_by_rod_y = (-(t36 * t469)).sub_product(c.inverse_bobbin_mass, t470);
    let bobbin_v_x_dot_by_rod_y = (-(t35 * t469)).sub_product(c.inverse_bobbin_mass, t471);
    let rod_omega_dot_by_rod_y = (t33 * t473).sub_product(R::literal(4_166.666_666_666_667), t475)
        .sub_product(t34, t472);
    let rod_v_y_dot_by_rod_y = t463.sub_product(t32, t474).sub_product(R::literal(5.0), t472);
    let rod_v_x_dot_by_rod_y = t461.add_product(t31, t474).sub_product(R::literal(5.0), t473);
    let cylinder_omega_dot_by_rod_y = (t454 * R::literal(2_777.777_777_777_778)).sub_product(t28,
        t477).add_product(t29, t476).sub_product(R::literal(-2_777.777_777_777_778), t475)
        .add_product(t30, t474);
    let cylinder_v_y_dot_by_rod_y = t457.sub_product(R::literal(3.333_333_333_333_333_5), t476)
        .add_product(t27, t474);
    let cylinder_v_x_dot_by_rod_y = t455.sub_product(R::literal(3.333_333_333_333_333_5), t477)
        .sub_product(t26, t474);
    let plate_omega_dot_by_rod_y = (t23 * t478).sub_product(t22, t479).sub_product(t22, t477)
        .add_product(t23, t476).add_product(t24, t471).sub_product(t25, t470);
    let plate_v_y_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t476))
        .sub_product(R::literal(0.833_333_333_333_333_4), t478)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t470);
    let plate_v_x_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t477))
        .sub_product(R::literal(0.833_333_333_333_333_4), t479)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t471);
    let post_omega_dot_by_rod_y = (t20 * t480).sub_product(t19, t481).sub_product(t19, t479)
        .add_product(t20, t478).sub_product(t21, t468);
    let post_v_y_dot_by_rod_y = (-(R::literal(-1.25) * t478)).sub_product(R::literal(1.25), t480);
    let post_v_x_dot_by_rod_y = (-(R::literal(-1.25) * t479)).sub_product(R::literal(1.25), t481);
    let t482 = (t7 * t239).add_product(t6, t240);
    let t483 = R::literal(4_166.666_666_666_667) * t482;
    let t484 = t113 * t483;
    let t485 = (-t199).add_product(t6, rod_omega_dot).add_product(t33, t482).add_product(t114, t483)
        .sub_product(t124, t484);
    let t486 = t198.add_product(t7, rod_omega_dot).sub_product(t34, t482).sub_product(t115, t483)
        .sub_product(t126, t484).sub_product(t135, t485);
    let t487 = (t117 * t483).sub_product(t128, t484).sub_product(t137, t485).sub_product(t144,
        t486);
    let t488 = (t119 * t483).sub_product(t130, t484).sub_product(t139, t485).sub_product(t146, t486)
        .sub_product(t151, t487);
    let t489 = (t152 * t487).sub_product(t157, t488);
    let t490 = (t121 * t483).sub_product(t132, t484).sub_product(t141, t485).sub_product(t148, t486)
        .sub_product(t154, t487).sub_product(t159, t488).sub_product(t164, t489) * t165;
    let t491 = (t489 * t162).sub_product(t164, t490);
    let t492 = (t488 * t155).sub_product(t157, t491).sub_product(t159, t490);
    let t493 = (t487 * t149).sub_product(t151, t492).add_product(t152, t491).sub_product(t154,
        t490);
    let t494 = (t486 * t142).sub_product(t144, t493).sub_product(t146, t492).sub_product(t148,
        t490);
    let t495 = (t485 * t133).sub_product(t135, t494).sub_product(t137, t493).sub_product(t139, t492)
        .sub_product(t141, t490);
    let t496 = (t484 * t122).sub_product(t124, t495).sub_product(t126, t494).sub_product(t128, t493)
        .sub_product(t130, t492).sub_product(t132, t490);
    let t497 = (-(t483 * t111)).sub_product(t113, t496).sub_product(t114, t495).add_product(t115,
        t494).sub_product(t117, t493).sub_product(t119, t492).sub_product(t121, t490);
    let t498 = (-(t104 * t496)).sub_product(t102, t497).sub_product(t106, t493).sub_product(t108,
        t492).sub_product(t110, t490);
    let t499 = (t91 * t497).sub_product(t89, t498).sub_product(t93, t496).sub_product(t95, t493)
        .sub_product(t97, t492).sub_product(t99, t490);
    let t500 = (-(t78 * t498)).sub_product(t76, t499).sub_product(t81, t493).sub_product(t84, t492)
        .sub_product(t86, t490);
    let t501 = (-(t64 * t499)).sub_product(t62, t500).sub_product(t65, t498).sub_product(t68, t493)
        .add_product(t70, t492).sub_product(t72, t490);
    let t502 = (-(t55 * t500)).sub_product(t53, t501).sub_product(t57, t490);
    let t503 = (-(t45 * t501)).sub_product(t43, t502).sub_product(t43, t500).add_product(t47, t490);
    let drum_v_y_dot_by_rod_phi = (t38 * t491).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t491);
    let drum_v_x_dot_by_rod_phi = (t37 * t491).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t491);
    let bobbin_v_y_dot_by_rod_phi = (-(t36 * t491)).sub_product(c.inverse_bobbin_mass, t492);
    let bobbin_v_x_dot_by_rod_phi = (-(t35 * t491)).sub_product(c.inverse_bobbin_mass, t493);
    let rod_omega_dot_by_rod_phi = t483.sub_product(R::literal(4_166.666_666_666_667), t497)
        .add_product(t33, t495).sub_product(t34, t494);
    let rod_v_y_dot_by_rod_phi = (-(R::literal(5.0) * t494)).sub_product(t32, t496);
    let rod_v_x_dot_by_rod_phi = (-(R::literal(5.0) * t495)).add_product(t31, t496);
    let cylinder_omega_dot_by_rod_phi = (t29 * t498).sub_product(t28, t499)
        .sub_product(R::literal(-2_777.777_777_777_778), t497).add_product(t30, t496);
    let cylinder_v_y_dot_by_rod_phi = (t27 * t496).sub_product(R::literal(3.333_333_333_333_333_5),
        t498);
    let cylinder_v_x_dot_by_rod_phi = (-(t26 * t496))
        .sub_product(R::literal(3.333_333_333_333_333_5), t499);
    let plate_omega_dot_by_rod_phi = (t23 * t500).sub_product(t22, t501).sub_product(t22, t499)
        .add_product(t23, t498).add_product(t24, t493).sub_product(t25, t492);
    let plate_v_y_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t498))
        .sub_product(R::literal(0.833_333_333_333_333_4), t500)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t492);
    let plate_v_x_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t499))
        .sub_product(R::literal(0.833_333_333_333_333_4), t501)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t493);
    let post_omega_dot_by_rod_phi = (t20 * t502).sub_product(t19, t503).sub_product(t19, t501)
        .add_product(t20, t500).sub_product(t21, t490);
    let post_v_y_dot_by_rod_phi = (-(R::literal(-1.25) * t500)).sub_product(R::literal(1.25), t502);
    let post_v_x_dot_by_rod_phi = (-(R::literal(-1.25) * t501)).sub_product(R::literal(1.25), t503);
    let t504 = t179 * bobbin_y_minus_drum_y / between_squared_times_between;
    let winding_force_over_between = p.winding_force / between;
    let t505 = R::literal(3.0) * bobbin_v_x;
    let t506 = t505 * bobbin_x_minus_drum_x;
    let t507 = t506 / between_squared_times_between;
    let t508 = between.powi(5);
    let t509 = bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t510 = R::literal(3.0) * drum_v_x;
    let t511 = t510 * t509 / t508;
    let t512 = R::literal(3.0) * drum_v_y;
    let t513 = t512 * bobbin_y_minus_drum_y;
    let t514 = t513 * bobbin_x_minus_drum_x_squared / t508;
    let t515 = bobbin_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t516 = t505 * t509 / t508;
    let t517 = R::literal(3.0) * bobbin_v_y;
    let t518 = t517 * bobbin_y_minus_drum_y;
    let t519 = t518 * bobbin_x_minus_drum_x_squared / t508;
    let t520 = t510 * bobbin_x_minus_drum_x;
    let t521 = t520 / between_squared_times_between;
    let t522 = drum_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t523 = t516 + t519 + t521 + t522 - t507 - t511 - t514 - t515;
    let t524 = t510 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t508;
    let t525 = t512 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t508;
    let t526 = bobbin_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t527 = t202 / between_squared_times_between;
    let t528 = t505 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t508;
    let t529 = t517 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t508;
    let t530 = drum_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t531 = drum_v_y_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t532 = t528 + t529 + t530 + t531 - t524 - t525 - t526 - t527;
    let t533 = t507 + t511 + t514 + t515 - t516 - t519 - t521 - t522;
    let t534 = t524 + t525 + t526 + t527 - t528 - t529 - t530 - t531;
    let inverse_between = R::literal(1.0) / between;
    let t535 = inverse_between - bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t536 = t535 * t236;
    let t537 = t504 - t536;
    let t538 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t539 = t538 * t236;
    let t540 = winding_force_over_between - p.winding_force * bobbin_x_minus_drum_x_squared
        / between_squared_times_between + t539;
    let t541 = t538 * bobbin_v_y_dot;
    let bobbin_x_plus_between_minus_drum_x = bobbin_x + between - drum_x;
    let bobbin_x_minus_drum_x_minus_between = bobbin_x_minus_drum_x - between;
    let t542 = bobbin_x_plus_between_minus_drum_x * bobbin_x_minus_drum_x_minus_between
        / between_squared_times_between;
    let t543 = t542 * t236;
    let t544 = t538 * drum_v_y_dot;
    let t545 = c.inverse_bobbin_mass * t537;
    let t546 = c.inverse_bobbin_mass * t540;
    let t547 = (-t546).add_product(t151, t545);
    let t548 = R::literal(0.666_666_666_666_666_6) * t543;
    let t549 = R::literal(0.666_666_666_666_666_6) * t539;
    let t550 = -t549;
    let t551 = t38 * t539;
    let t552 = bobbin_y_minus_drum_y_over_between * t549;
    let t553 = ((((-(bobbin_v_x * t523).add_product(bobbin_v_y, t532).add_product(drum_v_x, t533)
        .add_product(drum_v_y, t534)).sub_product(t535, bobbin_v_x_dot) + t541).sub_product(t542,
        drum_v_x_dot) - t544).sub_product(t35, t537).sub_product(t36, t540).sub_product(t37, t543)
        - t551).sub_product(t152, t545).sub_product(t157, t547)
        .add_product(bobbin_x_minus_drum_x_over_between, t548) + t552;
    let t554 = (t154 * t545).sub_product(t159, t547).sub_product(t164, t553) * t165;
    let t555 = (t553 * t162).sub_product(t164, t554);
    let t556 = (t547 * t155).sub_product(t157, t555).sub_product(t159, t554);
    let t557 = (-(t545 * t149)).sub_product(t151, t556).add_product(t152, t555).sub_product(t154,
        t554);
    let t558 = (-(t146 * t556)).sub_product(t144, t557).sub_product(t148, t554);
    let t559 = (-(t137 * t557)).sub_product(t135, t558).sub_product(t139, t556).sub_product(t141,
        t554);
    let t560 = (-(t126 * t558)).sub_product(t124, t559).sub_product(t128, t557).sub_product(t130,
        t556).sub_product(t132, t554);
    let t561 = (-(t114 * t559)).sub_product(t113, t560).add_product(t115, t558).sub_product(t117,
        t557).sub_product(t119, t556).sub_product(t121, t554);
    let t562 = (-(t104 * t560)).sub_product(t102, t561).sub_product(t106, t557).sub_product(t108,
        t556).sub_product(t110, t554);
    let t563 = (t91 * t561).sub_product(t89, t562).sub_product(t93, t560).sub_product(t95, t557)
        .sub_product(t97, t556).sub_product(t99, t554);
    let t564 = (-(t78 * t562)).sub_product(t76, t563).sub_product(t81, t557).sub_product(t84, t556)
        .sub_product(t86, t554);
    let t565 = (-(t64 * t563)).sub_product(t62, t564).sub_product(t65, t562).sub_product(t68, t557)
        .add_product(t70, t556).sub_product(t72, t554);
    let t566 = (-(t55 * t564)).sub_product(t53, t565).sub_product(t57, t554);
    let t567 = (-(t45 * t565)).sub_product(t43, t566).sub_product(t43, t564).add_product(t47, t554);
    let drum_v_y_dot_by_bobbin_x = t550.sub_product(R::literal(0.666_666_666_666_666_6), (-t539)
        .add_product(bobbin_y_minus_drum_y_over_between, t555)).add_product(t38, t555);
    let drum_v_x_dot_by_bobbin_x = (-t548).sub_product(R::literal(0.666_666_666_666_666_6), (-t543)
        .add_product(bobbin_x_minus_drum_x_over_between, t555)).add_product(t37, t555);
    let bobbin_v_y_dot_by_bobbin_x = t546.sub_product(c.inverse_bobbin_mass, t556).sub_product(t36,
        t555);
    let bobbin_v_x_dot_by_bobbin_x = t545.sub_product(c.inverse_bobbin_mass, t557).sub_product(t35,
        t555);
    let rod_omega_dot_by_bobbin_x = (t33 * t559).sub_product(R::literal(4_166.666_666_666_667),
        t561).sub_product(t34, t558);
    let rod_v_y_dot_by_bobbin_x = (-(R::literal(5.0) * t558)).sub_product(t32, t560);
    let rod_v_x_dot_by_bobbin_x = (-(R::literal(5.0) * t559)).add_product(t31, t560);
    let cylinder_omega_dot_by_bobbin_x = (t29 * t562).sub_product(t28, t563)
        .sub_product(R::literal(-2_777.777_777_777_778), t561).add_product(t30, t560);
    let cylinder_v_y_dot_by_bobbin_x = (t27 * t560)
        .sub_product(R::literal(3.333_333_333_333_333_5), t562);
    let cylinder_v_x_dot_by_bobbin_x = (-(t26 * t560))
        .sub_product(R::literal(3.333_333_333_333_333_5), t563);
    let plate_omega_dot_by_bobbin_x = (t23 * t564).sub_product(t22, t565).sub_product(t22, t563)
        .add_product(t23, t562).add_product(t24, t557).sub_product(t25, t556);
    let plate_v_y_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t562))
        .sub_product(R::literal(0.833_333_333_333_333_4), t564)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t556);
    let plate_v_x_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t563))
        .sub_product(R::literal(0.833_333_333_333_333_4), t565)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t557);
    let post_omega_dot_by_bobbin_x = (t20 * t566).sub_product(t19, t567).sub_product(t19, t565)
        .add_product(t20, t564).sub_product(t21, t554);
    let post_v_y_dot_by_bobbin_x = (-(R::literal(-1.25) * t564)).sub_product(R::literal(1.25),
        t566);
    let post_v_x_dot_by_bobbin_x = (-(R::literal(-1.25) * t565)).sub_product(R::literal(1.25),
        t567);
    let bobbin_y_plus_between_minus_drum_y = bobbin_y + between - drum_y;
    let bobbin_y_minus_drum_y_minus_between = bobbin_y_minus_drum_y - between;
    let t568 = -t504;
    let t569 = t518 / between_squared_times_between;
    let t570 = t520 * bobbin_y_minus_drum_y_squared / t508;
    let t571 = bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t572 = t512 * t571 / t508;
    let t573 = t206 / between_squared_times_between;
    let t574 = t506 * bobbin_y_minus_drum_y_squared / t508;
    let t575 = t517 * t571 / t508;
    let t576 = t513 / between_squared_times_between;
    let t577 = drum_v_x_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t578 = t574 + t575 + t576 + t577 - t569 - t570 - t572 - t573;
    let t579 = t569 + t570 + t572 + t573 - t574 - t575 - t576 - t577;
    let t580 = p.winding_force * bobbin_y_plus_between_minus_drum_y
        * bobbin_y_minus_drum_y_minus_between / between_squared_times_between + t539;
    let t581 = t538 * bobbin_v_x_dot;
    let t582 = inverse_between - bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t583 = t582 * t236;
    let t584 = t568 - t583;
    let t585 = t538 * drum_v_x_dot;
    let t586 = bobbin_y_plus_between_minus_drum_y * bobbin_y_minus_drum_y_minus_between
        / between_squared_times_between;
    let t587 = t586 * t236;
    let t588 = c.inverse_bobbin_mass * t580;
    let t589 = c.inverse_bobbin_mass * t584;
    let t590 = (-t589).add_product(t151, t588);
    let t591 = R::literal(0.666_666_666_666_666_6) * t587;
    let t592 = t37 * t539;
    let t593 = bobbin_x_minus_drum_x_over_between * t549;
    let t594 = ((((t581 - (bobbin_v_x * t532).add_product(bobbin_v_y, t578).add_product(drum_v_x,
        t534).add_product(drum_v_y, t579)).sub_product(t582, bobbin_v_y_dot) - t585)
        .sub_product(t586, drum_v_y_dot).sub_product(t35, t580).sub_product(t36, t584) - t592)
        .sub_product(t38, t587).sub_product(t152, t588).sub_product(t157, t590) + t593)
        .add_product(bobbin_y_minus_drum_y_over_between, t591);
    let t595 = (t154 * t588).sub_product(t159, t590).sub_product(t164, t594) * t165;
    let t596 = (t594 * t162).sub_product(t164, t595);
    let t597 = (t590 * t155).sub_product(t157, t596).sub_product(t159, t595);
    let t598 = (-(t588 * t149)).sub_product(t151, t597).add_product(t152, t596).sub_product(t154,
        t595);
    let t599 = (-(t146 * t597)).sub_product(t144, t598).sub_product(t148, t595);
    let t600 = (-(t137 * t598)).sub_product(t135, t599).sub_product(t139, t597).sub_product(t141,
        t595);
    let t601 = (-(t126 * t599)).sub_product(t124, t600).sub_product(t128, t598).sub_product(t130,
        t597).sub_product(t132, t595);
    let t602 = (-(t114 * t600)).sub_product(t113, t601).add_product(t115, t599).sub_product(t117,
        t598).sub_product(t119, t597).sub_product(t121, t595);
    let t603 = (-(t104 * t601)).sub_product(t102, t602).sub_product(t106, t598).sub_product(t108,
        t597).sub_product(t110, t595);
    let t604 = (t91 * t602).sub_product(t89, t603).sub_product(t93, t601).sub_product(t95, t598)
        .sub_product(t97, t597).sub_product(t99, t595);
    let t605 = (-(t78 * t603)).sub_product(t76, t604).sub_product(t81, t598).sub_product(t84, t597)
        .sub_product(t86, t595);
    let t606 = (-(t64 * t604)).sub_product(t62, t605).sub_product(t65, t603).sub_product(t68, t598)
        .add_product(t70, t597).sub_product(t72, t595);
    let t607 = (-(t55 * t605)).sub_product(t53, t606).sub_product(t57, t595);
    let t608 = (-(t45 * t606)).sub_product(t43, t607).sub_product(t43, t605).add_product(t47, t595);
    let drum_v_y_dot_by_bobbin_y = (-t591).sub_product(R::literal(0.666_666_666_666_666_6), (-t587)
        .add_product(bobbin_y_minus_drum_y_over_between, t596)).add_product(t38, t596);
    let drum_v_x_dot_by_bobbin_y = t550.sub_product(R::literal(0.666_666_666_666_666_6), (-t539)
        .add_product(bobbin_x_minus_drum_x_over_between, t596)).add_product(t37, t596);
    let bobbin_v_y_dot_by_bobbin_y = t589.sub_product(c.inverse_bobbin_mass, t597).sub_product(t36,
        t596);
    let bobbin_v_x_dot_by_bobbin_y = t588.sub_product(c.inverse_bobbin_mass, t598).sub_product(t35,
        t596);
    let rod_omega_dot_by_bobbin_y = (t33 * t600).sub_product(R::literal(4_166.666_666_666_667),
        t602).sub_product(t34, t599);
    let rod_v_y_dot_by_bobbin_y = (-(R::literal(5.0) * t599)).sub_product(t32, t601);
    let rod_v_x_dot_by_bobbin_y = (-(R::literal(5.0) * t600)).add_product(t31, t601);
    let cylinder_omega_dot_by_bobbin_y = (t29 * t603).sub_product(t28, t604)
        .sub_product(R::literal(-2_777.777_777_777_778), t602).add_product(t30, t601);
    let cylinder_v_y_dot_by_bobbin_y = (t27 * t601)
        .sub_product(R::literal(3.333_333_333_333_333_5), t603);
    let cylinder_v_x_dot_by_bobbin_y = (-(t26 * t601))
        .sub_product(R::literal(3.333_333_333_333_333_5), t604);
    let plate_omega_dot_by_bobbin_y = (t23 * t605).sub_product(t22, t606).sub_product(t22, t604)
        .add_product(t23, t603).add_product(t24, t598).sub_product(t25, t597);
    let plate_v_y_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t603))
        .sub_product(R::literal(0.833_333_333_333_333_4), t605)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t597);
    let plate_v_x_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t604))
        .sub_product(R::literal(0.833_333_333_333_333_4), t606)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t598);
    let post_omega_dot_by_bobbin_y = (t20 * t607).sub_product(t19, t608).sub_product(t19, t606)
        .add_product(t20, t605).sub_product(t21, t595);
    let post_v_y_dot_by_bobbin_y = (-(R::literal(-1.25) * t605)).sub_product(R::literal(1.25),
        t607);
    let post_v_x_dot_by_bobbin_y = (-(R::literal(-1.25) * t606)).sub_product(R::literal(1.25),
        t608);
    let t609 = t568 - t543;
    let t610 = p.winding_force * bobbin_x_plus_between_minus_drum_x
        * bobbin_x_minus_drum_x_minus_between / between_squared_times_between - t539;
    let t611 = c.inverse_bobbin_mass * t609;
    let t612 = c.inverse_bobbin_mass * t610;
    let t613 = (-t612).add_product(t151, t611);
    let t614 = R::literal(0.666_666_666_666_666_6) * t536;
    let t615 = ((((-(bobbin_v_y * t534).add_product(bobbin_v_x, t533).add_product(drum_v_x, t523)
        .add_product(drum_v_y, t532)).sub_product(t542, bobbin_v_x_dot) - t541).sub_product(t535,
        drum_v_x_dot) + t544).sub_product(t35, t609).sub_product(t36, t610).sub_product(t37, t536)
        + t551).sub_product(t152, t611).sub_product(t157, t613)
        .add_product(bobbin_x_minus_drum_x_over_between, t614) - t552;
    let t616 = (t154 * t611).sub_product(t159, t613).sub_product(t164, t615) * t165;
    let t617 = (t615 * t162).sub_product(t164, t616);
    let t618 = (t613 * t155).sub_product(t157, t617).sub_product(t159, t616);
    let t619 = (-(t611 * t149)).sub_product(t151, t618).add_product(t152, t617).sub_product(t154,
        t616);
    let t620 = (-(t146 * t618)).sub_product(t144, t619).sub_product(t148, t616);
    let t621 = (-(t137 * t619)).sub_product(t135, t620).sub_product(t139, t618).sub_product(t141,
        t616);
    let t622 = (-(t126 * t620)).sub_product(t124, t621).sub_product(t128, t619).sub_product(t130,
        t618).sub_product(t132, t616);
    let t623 = (-(t114 * t621)).sub_product(t113, t622).add_product(t115, t620).sub_product(t117,
        t619).sub_product(t119, t618).sub_product(t121, t616);
    let t624 = (-(t104 * t622)).sub_product(t102, t623).sub_product(t106, t619).sub_product(t108,
        t618).sub_product(t110, t616);
    let t625 = (t91 * t623).sub_product(t89, t624).sub_product(t93, t622).sub_product(t95, t619)
        .sub_product(t97, t618).sub_product(t99, t616);
    let t626 = (-(t78 * t624)).sub_product(t76, t625).sub_product(t81, t619).sub_product(t84, t618)
        .sub_product(t86, t616);
    let t627 = (-(t64 * t625)).sub_product(t62, t626).sub_product(t65, t624).sub_product(t68, t619)
        .add_product(t70, t618).sub_product(t72, t616);
    let t628 = (-(t55 * t626)).sub_product(t53, t627).sub_product(t57, t616);
    let t629 = (-(t45 * t627)).sub_product(t43, t628).sub_product(t43, t626).add_product(t47, t616);
    let drum_v_y_dot_by_drum_x = t549.sub_product(R::literal(0.666_666_666_666_666_6), t539
        .add_product(bobbin_y_minus_drum_y_over_between, t617)).add_product(t38, t617);
    let drum_v_x_dot_by_drum_x = (-t614).sub_product(R::literal(0.666_666_666_666_666_6), (-t536)
        .add_product(bobbin_x_minus_drum_x_over_between, t617)).add_product(t37, t617);
    let bobbin_v_y_dot_by_drum_x = t612.sub_product(c.inverse_bobbin_mass, t618).sub_product(t36,
        t617);
    let bobbin_v_x_dot_by_drum_x = t611.sub_product(c.inverse_bobbin_mass, t619).sub_product(t35,
        t617);
    let rod_omega_dot_by_drum_x = (t33 * t621).sub_product(R::literal(4_166.666_666_666_667), t623)
        .sub_product(t34, t620);
    let rod_v_y_dot_by_drum_x = (-(R::literal(5.0) * t620)).sub_product(t32, t622);
    let rod_v_x_dot_by_drum_x = (-(R::literal(5.0) * t621)).add_product(t31, t622);
    let cylinder_omega_dot_by_drum_x = (t29 * t624).sub_product(t28, t625)
        .sub_product(R::literal(-2_777.777_777_777_778), t623).add_product(t30, t622);
    let cylinder_v_y_dot_by_drum_x = (t27 * t622).sub_product(R::literal(3.333_333_333_333_333_5),
        t624);
    let cylinder_v_x_dot_by_drum_x = (-(t26 * t622))
        .sub_product(R::literal(3.333_333_333_333_333_5), t625);
    let plate_omega_dot_by_drum_x = (t23 * t626).sub_product(t22, t627).sub_product(t22, t625)
        .add_product(t23, t624).add_product(t24, t619).sub_product(t25, t618);
    let plate_v_y_dot_by_drum_x = (-(R::literal(-0.833_333_333_333_333_4) * t624))
        .sub_product(R::literal(0.833_333_333_333_333_4), t626)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t618);
    let plate_v_x_dot_by_drum_x = (-(R::literal(-0.833_333_333_333_333_4) * t625))
        .sub_product(R::literal(0.833_333_333_333_333_4), t627)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t619);
    let post_omega_dot_by_drum_x = (t20 * t628).sub_product(t19, t629).sub_product(t19, t627)
        .add_product(t20, t626).sub_product(t21, t616);
    let post_v_y_dot_by_drum_x = (-(R::literal(-1.25) * t626)).sub_product(R::literal(1.25), t628);
    let post_v_x_dot_by_drum_x = (-(R::literal(-1.25) * t627)).sub_product(R::literal(1.25), t629);
    let t630 = winding_force_over_between - p.winding_force * bobbin_y_minus_drum_y_squared
        / between_squared_times_between - t539;
    let t631 = t504 - t587;
    let t632 = c.inverse_bobbin_mass * t630;
    let t633 = c.inverse_bobbin_mass * t631;
    let t634 = (-t633).add_product(t151, t632);
    let t635 = R::literal(0.666_666_666_666_666_6) * t583;
    let t636 = ((((-(bobbin_v_x * t534).add_product(bobbin_v_y, t579).add_product(drum_v_x, t532)
        .add_product(drum_v_y, t578) - t581).sub_product(t586, bobbin_v_y_dot) + t585)
        .sub_product(t582, drum_v_y_dot).sub_product(t35, t630).sub_product(t36, t631) + t592)
        .sub_product(t38, t583).sub_product(t152, t632).sub_product(t157, t634) - t593)
        .add_product(bobbin_y_minus_drum_y_over_between, t635);
    let t637 = (t154 * t632).sub_product(t159, t634).sub_product(t164, t636) * t165;
    let t638 = (t636 * t162).sub_product(t164, t637);
    let t639 = (t634 * t155).sub_product(t157, t638).sub_product(t159, t637);
    let t640 = (-(t632 * t149)).sub_product(t151, t639).add_product(t152, t638).sub_product(t154,
        t637);
    let t641 = (-(t146 * t639)).sub_product(t144, t640).sub_product(t148, t637);
    let t642 = (-(t137 * t640)).sub_product(t135, t641).sub_product(t139, t639).sub_product(t141,
        t637);
    let t643 = (-(t126 * t641)).sub_product(t124, t642).sub_product(t128, t640).sub_product(t130,
        t639).sub_product(t132, t637);
    let t644 = (-(t114 * t642)).sub_product(t113, t643).add_product(t115, t641).sub_product(t117,
        t640).sub_product(t119, t639).sub_product(t121, t637);
    let t645 = (-(t104 * t643)).sub_product(t102, t644).sub_product(t106, t640).sub_product(t108,
        t639).sub_product(t110, t637);
    let t646 = (t91 * t644).sub_product(t89, t645).sub_product(t93, t643).sub_product(t95, t640)
        .sub_product(t97, t639).sub_product(t99, t637);
    let t647 = (-(t78 * t645)).sub_product(t76, t646).sub_product(t81, t640).sub_product(t84, t639)
        .sub_product(t86, t637);
    let t648 = (-(t64 * t646)).sub_product(t62, t647).sub_product(t65, t645).sub_product(t68, t640)
        .add_product(t70, t639).sub_product(t72, t637);
    let t649 = (-(t55 * t647)).sub_product(t53, t648).sub_product(t57, t637);
    let t650 = (-(t45 * t648)).sub_product(t43, t649).sub_product(t43, t647).add_product(t47, t637);
    let drum_v_y_dot_by_drum_y = (-t635).sub_product(R::literal(0.666_666_666_666_666_6), (-t583)
        .add_product(bobbin_y_minus_drum_y_over_between, t638)).add_product(t38, t638);
    let drum_v_x_dot_by_drum_y = t549.sub_product(R::literal(0.666_666_666_666_666_6), t539
        .add_product(bobbin_x_minus_drum_x_over_between, t638)).add_product(t37, t638);
    let bobbin_v_y_dot_by_drum_y = t633.sub_product(c.inverse_bobbin_mass, t639).sub_product(t36,
        t638);
    let bobbin_v_x_dot_by_drum_y = t632.sub_product(c.inverse_bobbin_mass, t640).sub_product(t35,
        t638);
    let rod_omega_dot_by_drum_y = (t33 * t642).sub_product(R::literal(4_166.666_666_666_667), t644)
        .sub_product(t34, t641);
    let rod_v_y_dot_by_drum_y = (-(R::literal(5.0) * t641)).sub_product(t32, t643);
    let rod_v_x_dot_by_drum_y = (-(R::literal(5.0) * t642)).add_product(t31, t643);
    let cylinder_omega_dot_by_drum_y = (t29 * t645).sub_product(t28, t646)
        .sub_product(R::literal(-2_777.777_777_777_778), t644).add_product(t30, t643);
    let cylinder_v_y_dot_by_drum_y = (t27 * t643).sub_product(R::literal(3.333_333_333_333_333_5),
        t645);
    let cylinder_v_x_dot_by_drum_y = (-(t26 * t643))
        .sub_product(R::literal(3.333_333_333_333_333_5), t646);
    let plate_omega_dot_by_drum_y = (t23 * t647).sub_product(t22, t648).sub_product(t22, t646)
        .add_product(t23, t645).add_product(t24, t640).sub_product(t25, t639);
    let plate_v_y_dot_by_drum_y = (-(R::literal(-0.833_333_333_333_333_4) * t645))
        .sub_product(R::literal(0.833_333_333_333_333_4), t647)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t639);
    let plate_v_x_dot_by_drum_y = (-(R::literal(-0.833_333_333_333_333_4) * t646))
        .sub_product(R::literal(0.833_333_333_333_333_4), t648)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t640);
    let post_omega_dot_by_drum_y = (t20 * t649).sub_product(t19, t650).sub_product(t19, t648)
        .add_product(t20, t647).sub_product(t21, t637);
    let post_v_y_dot_by_drum_y = (-(R::literal(-1.25) * t647)).sub_product(R::literal(1.25), t649);
    let post_v_x_dot_by_drum_y = (-(R::literal(-1.25) * t648)).sub_product(R::literal(1.25), t650);
    let t651 = R::literal(0.2) * post_omega;
    let t652 = t651 * cos_post_phi;
    let t653 = (-(t651 * sin_post_phi)).add_product(t43, t652);
    let t654 = (-t652).add_product(t45, t652).sub_product(t53, t653);
    let t655 = t653.sub_product(t55, t653).sub_product(t62, t654);
    let t656 = (-(t64 * t654)).sub_product(t76, t655);
    let t657 = (-(t65 * t654)).sub_product(t78, t655).sub_product(t89, t656);
    let t658 = (t91 * t656).sub_product(t102, t657);
    let t659 = (-(t93 * t656)).sub_product(t104, t657).sub_product(t113, t658);
    let t660 = (-(t114 * t658)).sub_product(t124, t659);
    let t661 = (t115 * t658).sub_product(t126, t659).sub_product(t135, t660);
    let t662 = (-(t68 * t654)).sub_product(t81, t655).sub_product(t95, t656).sub_product(t106, t657)
        .sub_product(t117, t658).sub_product(t128, t659).sub_product(t137, t660).sub_product(t144,
        t661);
    let t663 = (t70 * t654).sub_product(t84, t655).sub_product(t97, t656).sub_product(t108, t657)
        .sub_product(t119, t658).sub_product(t130, t659).sub_product(t139, t660).sub_product(t146,
        t661).sub_product(t151, t662);
    let t664 = (t152 * t662).sub_product(t157, t663);
    let t665 = (post_omega * (R::literal(0.286) * sin_post_phi).sub_product(R::literal(0.088),
        cos_post_phi)).sub_product(t47, t652).sub_product(t57, t653).sub_product(t72, t654)
        .sub_product(t86, t655).sub_product(t99, t656).sub_product(t110, t657).sub_product(t121,
        t658).sub_product(t132, t659).sub_product(t141, t660).sub_product(t148, t661)
        .sub_product(t154, t662).sub_product(t159, t663).sub_product(t164, t664) * t165;
    let t666 = (t664 * t162).sub_product(t164, t665);
    let t667 = (t663 * t155).sub_product(t157, t666).sub_product(t159, t665);
    let t668 = (t662 * t149).sub_product(t151, t667).add_product(t152, t666).sub_product(t154,
        t665);
    let t669 = (t661 * t142).sub_product(t144, t668).sub_product(t146, t667).sub_product(t148,
        t665);
    let t670 = (t660 * t133).sub_product(t135, t669).sub_product(t137, t668).sub_product(t139, t667)
        .sub_product(t141, t665);
    let t671 = (t659 * t122).sub_product(t124, t670).sub_product(t126, t669).sub_product(t128, t668)
        .sub_product(t130, t667).sub_product(t132, t665);
    let t672 = (t658 * t111).sub_product(t113, t671).sub_product(t114, t670).add_product(t115, t669)
        .sub_product(t117, t668).sub_product(t119, t667).sub_product(t121, t665);
    let t673 = (t657 * t100).sub_product(t102, t672).sub_product(t104, t671).sub_product(t106, t668)
        .sub_product(t108, t667).sub_product(t110, t665);
    let t674 = (t656 * t87).sub_product(t89, t673).add_product(t91, t672).sub_product(t93, t671)
        .sub_product(t95, t668).sub_product(t97, t667).sub_product(t99, t665);
    let t675 = (t655 * t74).sub_product(t76, t674).sub_product(t78, t673).sub_product(t81, t668)
        .sub_product(t84, t667).sub_product(t86, t665);
    let t676 = (t654 * t59).sub_product(t62, t675).sub_product(t64, t674).sub_product(t65, t673)
        .sub_product(t68, t668).add_product(t70, t667).sub_product(t72, t665);
    let t677 = (t653 * t51).sub_product(t53, t676).sub_product(t55, t675).sub_product(t57, t665);
    let t678 = (-(t652 * t41)).sub_product(t43, t677).sub_product(t45, t676).sub_product(t43, t675)
        .add_product(t47, t665);
    let drum_v_y_dot_by_post_omega = (t38 * t666).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t666);
    let drum_v_x_dot_by_post_omega = (t37 * t666).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t666);
    let bobbin_v_y_dot_by_post_omega = (-(t36 * t666)).sub_product(c.inverse_bobbin_mass, t667);
    let bobbin_v_x_dot_by_post_omega = (-(t35 * t666)).sub_product(c.inverse_bobbin_mass, t668);
    let rod_omega_dot_by_post_omega = (t33 * t670).sub_product(R::literal(4_166.666_666_666_667),
        t672).sub_product(t34, t669);
    let rod_v_y_dot_by_post_omega = (-(R::literal(5.0) * t669)).sub_product(t32, t671);
    let rod_v_x_dot_by_post_omega = (-(R::literal(5.0) * t670)).add_product(t31, t671);
    let cylinder_omega_dot_by_post_omega = (t29 * t673).sub_product(t28, t674)
        .sub_product(R::literal(-2_777.777_777_777_778), t672).add_product(t30, t671);
    let cylinder_v_y_dot_by_post_omega = (t27 * t671)
        .sub_product(R::literal(3.333_333_333_333_333_5), t673);
    let cylinder_v_x_dot_by_post_omega = (-(t26 * t671))
        .sub_product(R::literal(3.333_333_333_333_333_5), t674);
    let plate_omega_dot_by_post_omega = (t23 * t675).sub_product(t22, t676).sub_product(t22, t674)
        .add_product(t23, t673).add_product(t24, t668).sub_product(t25, t667);
    let plate_v_y_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t673))
        .sub_product(R::literal(0.833_333_333_333_333_4), t675)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t667);
    let plate_v_x_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t674))
        .sub_product(R::literal(0.833_333_333_333_333_4), t676)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t668);
    let post_omega_dot_by_post_omega = (t20 * t677).sub_product(t19, t678).sub_product(t19, t676)
        .add_product(t20, t675).sub_product(t21, t665);
    let post_v_y_dot_by_post_omega = (-(R::literal(-1.25) * t675)).sub_product(R::literal(1.25),
        t677);
    let post_v_x_dot_by_post_omega = (-(R::literal(-1.25) * t676)).sub_product(R::literal(1.25),
        t678);
    let t679 = R::literal(0.12) * plate_omega;
    let t680 = t679 * cos_plate_phi;
    let t681 = t679 * sin_plate_phi;
    let t682 = (-t681).add_product(t62, t680);
    let t683 = (-t680).add_product(t64, t680).sub_product(t76, t682);
    let t684 = (-t681).add_product(t65, t680).sub_product(t78, t682).sub_product(t89, t683);
    let t685 = (t91 * t683).sub_product(t102, t684);
    let t686 = (-(t93 * t683)).sub_product(t104, t684).sub_product(t113, t685);
    let t687 = (-(t114 * t685)).sub_product(t124, t686);
    let t688 = (t115 * t685).sub_product(t126, t686).sub_product(t135, t687);
    let t689 = (plate_omega * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2),
        sin_plate_phi)).add_product(t68, t680).sub_product(t81, t682).sub_product(t95, t683)
        .sub_product(t106, t684).sub_product(t117, t685).sub_product(t128, t686).sub_product(t137,
        t687).sub_product(t144, t688);
    let t690 = (plate_omega * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2),
        cos_plate_phi)).sub_product(t70, t680).sub_product(t84, t682).sub_product(t97, t683)
        .sub_product(t108, t684).sub_product(t119, t685).sub_product(t130, t686).sub_product(t139,
        t687).sub_product(t146, t688).sub_product(t151, t689);
    let t691 = (t152 * t689).sub_product(t157, t690);
    let t692 = (t72 * t680).sub_product(t86, t682).sub_product(t99, t683).sub_product(t110, t684)
        .sub_product(t121, t685).sub_product(t132, t686).sub_product(t141, t687).sub_product(t148,
        t688).sub_product(t154, t689).sub_product(t159, t690).sub_product(t164, t691) * t165;
    let t693 = (t691 * t162).sub_product(t164, t692);
    let t694 = (t690 * t155).sub_product(t157, t693).sub_product(t159, t692);
    let t695 = (t689 * t149).sub_product(t151, t694).add_product(t152, t693).sub_product(t154,
        t692);
    let t696 = (t688 * t142).sub_product(t144, t695).sub_product(t146, t694).sub_product(t148,
        t692);
    let t697 = (t687 * t133).sub_product(t135, t696).sub_product(t137, t695).sub_product(t139, t694)
        .sub_product(t141, t692);
    let t698 = (t686 * t122).sub_product(t124, t697).sub_product(t126, t696).sub_product(t128, t695)
        .sub_product(t130, t694).sub_product(t132, t692);
    let t699 = (t685 * t111).sub_product(t113, t698).sub_product(t114, t697).add_product(t115, t696)
        .sub_product(t117, t695).sub_product(t119, t694).sub_product(t121, t692);
    let t700 = (t684 * t100).sub_product(t102, t699).sub_product(t104, t698).sub_product(t106, t695)
        .sub_product(t108, t694).sub_product(t110, t692);
    let t701 = (t683 * t87).sub_product(t89, t700).add_product(t91, t699).sub_product(t93, t698)
        .sub_product(t95, t695).sub_product(t97, t694).sub_product(t99, t692);
    let t702 = (t682 * t74).sub_product(t76, t701).sub_product(t78, t700).sub_product(t81, t695)
        .sub_product(t84, t694).sub_product(t86, t692);
    let t703 = (-(t680 * t59)).sub_product(t62, t702).sub_product(t64, t701).sub_product(t65, t700)
        .sub_product(t68, t695).add_product(t70, t694).sub_product(t72, t692);
    let t704 = (-(t55 * t702)).sub_product(t53, t703).sub_product(t57, t692);
    let t705 = (-(t45 * t703)).sub_product(t43, t704).sub_product(t43, t702).add_product(t47, t692);
    let drum_v_y_dot_by_plate_omega = (t38 * t693).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t693);
    let drum_v_x_dot_by_plate_omega = (t37 * t693).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t693);
    let bobbin_v_y_dot_by_plate_omega = (-(t36 * t693)).sub_product(c.inverse_bobbin_mass, t694);
    let bobbin_v_x_dot_by_plate_omega = (-(t35 * t693)).sub_product(c.inverse_bobbin_mass, t695);
    let rod_omega_dot_by_plate_omega = (t33 * t697).sub_product(R::literal(4_166.666_666_666_667),
        t699).sub_product(t34, t696);
    let rod_v_y_dot_by_plate_omega = (-(R::literal(5.0) * t696)).sub_product(t32, t698);
    let rod_v_x_dot_by_plate_omega = (-(R::literal(5.0) * t697)).add_product(t31, t698);
    let cylinder_omega_dot_by_plate_omega = (t29 * t700).sub_product(t28, t701)
        .sub_product(R::literal(-2_777.777_777_777_778), t699).add_product(t30, t698);
    let cylinder_v_y_dot_by_plate_omega = (t27 * t698)
        .sub_product(R::literal(3.333_333_333_333_333_5), t700);
    let cylinder_v_x_dot_by_plate_omega = (-(t26 * t698))
        .sub_product(R::literal(3.333_333_333_333_333_5), t701);
    let plate_omega_dot_by_plate_omega = (t23 * t702).sub_product(t22, t703).sub_product(t22, t701)
        .add_product(t23, t700).add_product(t24, t695).sub_product(t25, t694);
    let plate_v_y_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t700))
        .sub_product(R::literal(0.833_333_333_333_333_4), t702)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t694);
    let plate_v_x_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t701))
        .sub_product(R::literal(0.833_333_333_333_333_4), t703)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t695);
    let post_omega_dot_by_plate_omega = (t20 * t704).sub_product(t19, t705).sub_product(t19, t703)
        .add_product(t20, t702).sub_product(t21, t692);
    let post_v_y_dot_by_plate_omega = (-(R::literal(-1.25) * t702)).sub_product(R::literal(1.25),
        t704);
    let post_v_x_dot_by_plate_omega = (-(R::literal(-1.25) * t703)).sub_product(R::literal(1.25),
        t705);
    let cos_cylinder_phi_squared = cos_cylinder_phi * cos_cylinder_phi;
    let t706 = R::literal(50.0) * cos_cylinder_phi_squared;
    let t707 = R::literal(50.0) * sin_cylinder_phi * cos_cylinder_phi;
    let t708 = R::literal(50.0) * t14;
    let t709 = t708 * cos_cylinder_phi;
    let t710 = R::literal(2.0) * cylinder_omega;
    let t711 = t710 * cos_cylinder_phi;
    let t712 = R::literal(166.666_666_666_666_69) * cos_cylinder_phi_squared;
    let t713 = t28 * t709;
    let t714 = t712 - t713;
    let t715 = R::literal(3.333_333_333_333_333_5) * t707;
    let t716 = -t715;
    let t717 = t29 * t709;
    let t718 = (t715 + t717).sub_product(t89, t714);
    let t719 = R::literal(-2_777.777_777_777_778) * t709;
    let t720 = (-t719).add_product(t91, t714).sub_product(t102, t718);
    let t721 = t26 * t706;
    let t722 = t27 * t707;
    let t723 = t30 * t709;
    let t724 = t31 * t706;
    let t725 = t32 * t707;
    let t726 = (t721 - t711 - t722 + t723 + t724 - t725).sub_product(t93, t714).sub_product(t104,
        t718).sub_product(t113, t720);
    let t727 = R::literal(250.0) * cos_cylinder_phi_squared;
    let t728 = (-t727).sub_product(t114, t720).sub_product(t124, t726);
    let t729 = R::literal(5.0) * t707;
    let t730 = -t729;
    let t731 = (-t729).add_product(t115, t720).sub_product(t126, t726).sub_product(t135, t728);
    let t732 = (-(t95 * t714)).sub_product(t106, t718).sub_product(t117, t720).sub_product(t128,
        t726).sub_product(t137, t728).sub_product(t144, t731);
    let t733 = (-(t97 * t714)).sub_product(t108, t718).sub_product(t119, t720).sub_product(t130,
        t726).sub_product(t139, t728).sub_product(t146, t731).sub_product(t151, t732);
    let t734 = (t152 * t732).sub_product(t157, t733);
    let t735 = t709 * R::literal(2_777.777_777_777_778);
    let t736 = (-(t99 * t714)).sub_product(t110, t718).sub_product(t121, t720).sub_product(t132,
        t726).sub_product(t141, t728).sub_product(t148, t731).sub_product(t154, t732)
        .sub_product(t159, t733).sub_product(t164, t734) * t165;
    let t737 = (t734 * t162).sub_product(t164, t736);
    let t738 = (t733 * t155).sub_product(t157, t737).sub_product(t159, t736);
    let t739 = (t732 * t149).sub_product(t151, t738).add_product(t152, t737).sub_product(t154,
        t736);
    let t740 = (t731 * t142).sub_product(t144, t739).sub_product(t146, t738).sub_product(t148,
        t736);
    let t741 = (t728 * t133).sub_product(t135, t740).sub_product(t137, t739).sub_product(t139, t738)
        .sub_product(t141, t736);
    let t742 = (t726 * t122).sub_product(t124, t741).sub_product(t126, t740).sub_product(t128, t739)
        .sub_product(t130, t738).sub_product(t132, t736);
    let t743 = (t720 * t111).sub_product(t113, t742).sub_product(t114, t741).add_product(t115, t740)
        .sub_product(t117, t739).sub_product(t119, t738).sub_product(t121, t736);
    let t744 = (t718 * t100).sub_product(t102, t743).sub_product(t104, t742).sub_product(t106, t739)
        .sub_product(t108, t738).sub_product(t110, t736);
    let t745 = (t714 * t87).sub_product(t89, t744).add_product(t91, t743).sub_product(t93, t742)
        .sub_product(t95, t739).sub_product(t97, t738).sub_product(t99, t736);
    let t746 = (-(t78 * t744)).sub_product(t76, t745).sub_product(t81, t739).sub_product(t84, t738)
        .sub_product(t86, t736);
    let t747 = (-(t64 * t745)).sub_product(t62, t746).sub_product(t65, t744).sub_product(t68, t739)
        .add_product(t70, t738).sub_product(t72, t736);
    let t748 = (-(t55 * t746)).sub_product(t53, t747).sub_product(t57, t736);
    let t749 = (-(t45 * t747)).sub_product(t43, t748).sub_product(t43, t746).add_product(t47, t736);
    let drum_v_y_dot_by_cylinder_v_x = (t38 * t737)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t737);
    let drum_v_x_dot_by_cylinder_v_x = (t37 * t737)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t737);
    let bobbin_v_y_dot_by_cylinder_v_x = (-(t36 * t737)).sub_product(c.inverse_bobbin_mass, t738);
    let bobbin_v_x_dot_by_cylinder_v_x = (-(t35 * t737)).sub_product(c.inverse_bobbin_mass, t739);
    let rod_omega_dot_by_cylinder_v_x = (t33 * t741).sub_product(R::literal(4_166.666_666_666_667),
        t743).sub_product(t34, t740);
    let rod_v_y_dot_by_cylinder_v_x = t729.sub_product(t32, t742).sub_product(R::literal(5.0),
        t740);
    let rod_v_x_dot_by_cylinder_v_x = t727.add_product(t31, t742).sub_product(R::literal(5.0),
        t741);
    let cylinder_omega_dot_by_cylinder_v_x = t735.sub_product(t28, t745).add_product(t29, t744)
        .sub_product(R::literal(-2_777.777_777_777_778), t743).add_product(t30, t742);
    let cylinder_v_y_dot_by_cylinder_v_x = t716.sub_product(R::literal(3.333_333_333_333_333_5),
        t744).add_product(t27, t742);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t712).sub_product(R::literal(3.333_333_333_333_333_5),
        t745).sub_product(t26, t742);
    let plate_omega_dot_by_cylinder_v_x = (t23 * t746).sub_product(t22, t747).sub_product(t22, t745)
        .add_product(t23, t744).add_product(t24, t739).sub_product(t25, t738);
    let plate_v_y_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t744))
        .sub_product(R::literal(0.833_333_333_333_333_4), t746)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t738);
    let plate_v_x_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t745))
        .sub_product(R::literal(0.833_333_333_333_333_4), t747)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t739);
    let post_omega_dot_by_cylinder_v_x = (t20 * t748).sub_product(t19, t749).sub_product(t19, t747)
        .add_product(t20, t746).sub_product(t21, t736);
    let post_v_y_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t746)).sub_product(R::literal(1.25),
        t748);
    let post_v_x_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t747)).sub_product(R::literal(1.25),
        t749);
    let sin_cylinder_phi_squared = sin_cylinder_phi * sin_cylinder_phi;
    let t750 = R::literal(50.0) * sin_cylinder_phi_squared;
    let t751 = t708 * sin_cylinder_phi;
    let t752 = t710 * sin_cylinder_phi;
    let t753 = t28 * t751;
    let t754 = t715 - t753;
    let t755 = R::literal(166.666_666_666_666_69) * sin_cylinder_phi_squared;
    let t756 = -t755;
    let t757 = t29 * t751;
    let t758 = (t755 + t757).sub_product(t89, t754);
    let t759 = R::literal(-2_777.777_777_777_778) * t751;
    let t760 = (-t759).add_product(t91, t754).sub_product(t102, t758);
    let t761 = t26 * t707;
    let t762 = t27 * t750;
    let t763 = t30 * t751;
    let t764 = t31 * t707;
    let t765 = t32 * t750;
    let t766 = (t761 - t752 - t762 + t763 + t764 - t765).sub_product(t93, t754).sub_product(t104,
        t758).sub_product(t113, t760);
    let t767 = t730.sub_product(t114, t760).sub_product(t124, t766);
    let t768 = R::literal(250.0) * sin_cylinder_phi_squared;
    let t769 = (-t768).add_product(t115, t760).sub_product(t126, t766).sub_product(t135, t767);
    let t770 = (-(t95 * t754)).sub_product(t106, t758).sub_product(t117, t760).sub_product(t128,
        t766).sub_product(t137, t767).sub_product(t144, t769);
    let t771 = (-(t97 * t754)).sub_product(t108, t758).sub_product(t119, t760).sub_product(t130,
        t766).sub_product(t139, t767).sub_product(t146, t769).sub_product(t151, t770);
    let t772 = (t152 * t770).sub_product(t157, t771);
    let t773 = t751 * R::literal(2_777.777_777_777_778);
    let t774 = (-(t99 * t754)).sub_product(t110, t758).sub_product(t121, t760).sub_product(t132,
        t766).sub_product(t141, t767).sub_product(t148, t769).sub_product(t154, t770)
        .sub_product(t159, t771).sub_product(t164, t772) * t165;
    let t775 = (t772 * t162).sub_product(t164, t774);
    let t776 = (t771 * t155).sub_product(t157, t775).sub_product(t159, t774);
    let t777 = (t770 * t149).sub_product(t151, t776).add_product(t152, t775).sub_product(t154,
        t774);
    let t778 = (t769 * t142).sub_product(t144, t777).sub_product(t146, t776).sub_product(t148,
        t774);
    let t779 = (t767 * t133).sub_product(t135, t778).sub_product(t137, t777).sub_product(t139, t776)
        .sub_product(t141, t774);
    let t780 = (t766 * t122).sub_product(t124, t779).sub_product(t126, t778).sub_product(t128, t777)
        .sub_product(t130, t776).sub_product(t132, t774);
    let t781 = (t760 * t111).sub_product(t113, t780).sub_product(t114, t779).add_product(t115, t778)
        .sub_product(t117, t777).sub_product(t119, t776).sub_product(t121, t774);
    let t782 = (t758 * t100).sub_product(t102, t781).sub_product(t104, t780).sub_product(t106, t777)
        .sub_product(t108, t776).sub_product(t110, t774);
    let t783 = (t754 * t87).sub_product(t89, t782).add_product(t91, t781).sub_product(t93, t780)
        .sub_product(t95, t777).sub_product(t97, t776).sub_product(t99, t774);
    let t784 = (-(t78 * t782)).sub_product(t76, t783).sub_product(t81, t777).sub_product(t84, t776)
        .sub_product(t86, t774);
    let t785 = (-(t64 * t783)).sub_product(t62, t784).sub_product(t65, t782).sub_product(t68, t777)
        .add_product(t70, t776).sub_product(t72, t774);
    let t786 = (-(t55 * t784)).sub_product(t53, t785).sub_product(t57, t774);
    let t787 = (-(t45 * t785)).sub_product(t43, t786).sub_product(t43, t784).add_product(t47, t774);
    let drum_v_y_dot_by_cylinder_v_y = (t38 * t775)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t775);
    let drum_v_x_dot_by_cylinder_v_y = (t37 * t775)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t775);
    let bobbin_v_y_dot_by_cylinder_v_y = (-(t36 * t775)).sub_product(c.inverse_bobbin_mass, t776);
    let bobbin_v_x_dot_by_cylinder_v_y = (-(t35 * t775)).sub_product(c.inverse_bobbin_mass, t777);
    let rod_omega_dot_by_cylinder_v_y = (t33 * t779).sub_product(R::literal(4_166.666_666_666_667),
        t781).sub_product(t34, t778);
    let rod_v_y_dot_by_cylinder_v_y = t768.sub_product(t32, t780).sub_product(R::literal(5.0),
        t778);
    let rod_v_x_dot_by_cylinder_v_y = t729.add_product(t31, t780).sub_product(R::literal(5.0),
        t779);
    let cylinder_omega_dot_by_cylinder_v_y = t773.sub_product(t28, t783).add_product(t29, t782)
        .sub_product(R::literal(-2_777.777_777_777_778), t781).add_product(t30, t780);
    let cylinder_v_y_dot_by_cylinder_v_y = t756.sub_product(R::literal(3.333_333_333_333_333_5),
        t782).add_product(t27, t780);
    let cylinder_v_x_dot_by_cylinder_v_y = t716.sub_product(R::literal(3.333_333_333_333_333_5),
        t783).sub_product(t26, t780);
    let plate_omega_dot_by_cylinder_v_y = (t23 * t784).sub_product(t22, t785).sub_product(t22, t783)
        .add_product(t23, t782).add_product(t24, t777).sub_product(t25, t776);
    let plate_v_y_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t782))
        .sub_product(R::literal(0.833_333_333_333_333_4), t784)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t776);
    let plate_v_x_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t783))
        .sub_product(R::literal(0.833_333_333_333_333_4), t785)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t777);
    let post_omega_dot_by_cylinder_v_y = (t20 * t786).sub_product(t19, t787).sub_product(t19, t785)
        .add_product(t20, t784).sub_product(t21, t774);
    let post_v_y_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t784)).sub_product(R::literal(1.25),
        t786);
    let post_v_x_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t785)).sub_product(R::literal(1.25),
        t787);
    let t788 = R::literal(50.0) * t391;
    let t789 = R::literal(0.12) * cylinder_omega;
    let t790 = R::literal(3.333_333_333_333_333_5) * t709;
    let t791 = (-t790).sub_product(t789, cos_cylinder_phi).add_product(t28, t788);
    let t792 = R::literal(3.333_333_333_333_333_5) * t751;
    let t793 = (-t792).sub_product(t789, sin_cylinder_phi).sub_product(t29, t788).sub_product(t89,
        t791);
    let t794 = (R::literal(-138_888.888_888_888_9) * t391).add_product(t91, t791).sub_product(t102,
        t793);
    let t795 = (-(t26 * t709)).add_product(R::literal(2.0), ((t195 + t196).add_product(rod_v_x,
        cos_cylinder_phi).add_product(rod_v_y, sin_cylinder_phi) - t191 - t192)
        .sub_product(cylinder_v_x, cos_cylinder_phi).sub_product(cylinder_v_y, sin_cylinder_phi))
        .add_product(t27, t751).sub_product(t30, t788).sub_product(t31, t709).add_product(t32, t751)
        .sub_product(t93, t791).sub_product(t104, t793).sub_product(t113, t794);
    let t796 = R::literal(5.0) * t709;
    let t797 = t796.sub_product(t114, t794).sub_product(t124, t795);
    let t798 = R::literal(5.0) * t751;
    let t799 = t798.add_product(t115, t794).sub_product(t126, t795).sub_product(t135, t797);
    let t800 = (-(t95 * t791)).sub_product(t106, t793).sub_product(t117, t794).sub_product(t128,
        t795).sub_product(t137, t797).sub_product(t144, t799);
    let t801 = (-(t97 * t791)).sub_product(t108, t793).sub_product(t119, t794).sub_product(t130,
        t795).sub_product(t139, t797).sub_product(t146, t799).sub_product(t151, t800);
    let t802 = (t152 * t800).sub_product(t157, t801);
    let t803 = (-(t99 * t791)).sub_product(t110, t793).sub_product(t121, t794).sub_product(t132,
        t795).sub_product(t141, t797).sub_product(t148, t799).sub_product(t154, t800)
        .sub_product(t159, t801).sub_product(t164, t802) * t165;
    let t804 = (t802 * t162).sub_product(t164, t803);
    let t805 = (t801 * t155).sub_product(t157, t804).sub_product(t159, t803);
    let t806 = (t800 * t149).sub_product(t151, t805).add_product(t152, t804).sub_product(t154,
        t803);
    let t807 = (t799 * t142).sub_product(t144, t806).sub_product(t146, t805).sub_product(t148,
        t803);
    let t808 = (t797 * t133).sub_product(t135, t807).sub_product(t137, t806).sub_product(t139, t805)
        .sub_product(t141, t803);
    let t809 = (t795 * t122).sub_product(t124, t808).sub_product(t126, t807).sub_product(t128, t806)
        .sub_product(t130, t805).sub_product(t132, t803);
    let t810 = (t794 * t111).sub_product(t113, t809).sub_product(t114, t808).add_product(t115, t807)
        .sub_product(t117, t806).sub_product(t119, t805).sub_product(t121, t803);
    let t811 = (t793 * t100).sub_product(t102, t810).sub_product(t104, t809).sub_product(t106, t806)
        .sub_product(t108, t805).sub_product(t110, t803);
    let t812 = (t791 * t87).sub_product(t89, t811).add_product(t91, t810).sub_product(t93, t809)
        .sub_product(t95, t806).sub_product(t97, t805).sub_product(t99, t803);
    let t813 = (-(t78 * t811)).sub_product(t76, t812).sub_product(t81, t806).sub_product(t84, t805)
        .sub_product(t86, t803);
    let t814 = (-(t64 * t812)).sub_product(t62, t813).sub_product(t65, t811).sub_product(t68, t806)
        .add_product(t70, t805).sub_product(t72, t803);
    let t815 = (-(t55 * t813)).sub_product(t53, t814).sub_product(t57, t803);
    let t816 = (-(t45 * t814)).sub_product(t43, t815).sub_product(t43, t813).add_product(t47, t803);
    let drum_v_y_dot_by_cylinder_omega = (t38 * t804)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t804);
    let drum_v_x_dot_by_cylinder_omega = (t37 * t804)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t804);
    let bobbin_v_y_dot_by_cylinder_omega = (-(t36 * t804)).sub_product(c.inverse_bobbin_mass, t805);
    let bobbin_v_x_dot_by_cylinder_omega = (-(t35 * t804)).sub_product(c.inverse_bobbin_mass, t806);
    let rod_omega_dot_by_cylinder_omega = (t33 * t808)
        .sub_product(R::literal(4_166.666_666_666_667), t810).sub_product(t34, t807);
    let rod_v_y_dot_by_cylinder_omega = (-t798).sub_product(t32, t809).sub_product(R::literal(5.0),
        t807);
    let rod_v_x_dot_by_cylinder_omega = (-t796).add_product(t31, t809).sub_product(R::literal(5.0),
        t808);
    let cylinder_omega_dot_by_cylinder_omega = (-(R::literal(138_888.888_888_888_9) * t391))
        .sub_product(t28, t812).add_product(t29, t811)
        .sub_product(R::literal(-2_777.777_777_777_778), t810).add_product(t30, t809);
    let cylinder_v_y_dot_by_cylinder_omega = t792.sub_product(R::literal(3.333_333_333_333_333_5),
        t811).add_product(t27, t809);
    let cylinder_v_x_dot_by_cylinder_omega = t790.sub_product(R::literal(3.333_333_333_333_333_5),
        t812).sub_product(t26, t809);
    let plate_omega_dot_by_cylinder_omega = (t23 * t813).sub_product(t22, t814).sub_product(t22,
        t812).add_product(t23, t811).add_product(t24, t806).sub_product(t25, t805);
    let plate_v_y_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4) * t811))
        .sub_product(R::literal(0.833_333_333_333_333_4), t813)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t805);
    let plate_v_x_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4) * t812))
        .sub_product(R::literal(0.833_333_333_333_333_4), t814)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t806);
    let post_omega_dot_by_cylinder_omega = (t20 * t815).sub_product(t19, t816).sub_product(t19,
        t814).add_product(t20, t813).sub_product(t21, t803);
    let post_v_y_dot_by_cylinder_omega = (-(R::literal(-1.25) * t813))
        .sub_product(R::literal(1.25), t815);
    let post_v_x_dot_by_cylinder_omega = (-(R::literal(-1.25) * t814))
        .sub_product(R::literal(1.25), t816);
    let t817 = t713 - t712;
    let t818 = (t716 - t717).sub_product(t89, t817);
    let t819 = t719.add_product(t91, t817).sub_product(t102, t818);
    let t820 = (t711 - t721 + t722 - t723 - t724 + t725).sub_product(t93, t817).sub_product(t104,
        t818).sub_product(t113, t819);
    let t821 = t727.sub_product(t114, t819).sub_product(t124, t820);
    let t822 = t729.add_product(t115, t819).sub_product(t126, t820).sub_product(t135, t821);
    let t823 = (-(t95 * t817)).sub_product(t106, t818).sub_product(t117, t819).sub_product(t128,
        t820).sub_product(t137, t821).sub_product(t144, t822);
    let t824 = (-(t97 * t817)).sub_product(t108, t818).sub_product(t119, t819).sub_product(t130,
        t820).sub_product(t139, t821).sub_product(t146, t822).sub_product(t151, t823);
    let t825 = (t152 * t823).sub_product(t157, t824);
    let t826 = (-(t99 * t817)).sub_product(t110, t818).sub_product(t121, t819).sub_product(t132,
        t820).sub_product(t141, t821).sub_product(t148, t822).sub_product(t154, t823)
        .sub_product(t159, t824).sub_product(t164, t825) * t165;
    let t827 = (t825 * t162).sub_product(t164, t826);
    let t828 = (t824 * t155).sub_product(t157, t827).sub_product(t159, t826);
    let t829 = (t823 * t149).sub_product(t151, t828).add_product(t152, t827).sub_product(t154,
        t826);
    let t830 = (t822 * t142).sub_product(t144, t829).sub_product(t146, t828).sub_product(t148,
        t826);
    let t831 = (t821 * t133).sub_product(t135, t830).sub_product(t137, t829).sub_product(t139, t828)
        .sub_product(t141, t826);
    let t832 = (t820 * t122).sub_product(t124, t831).sub_product(t126, t830).sub_product(t128, t829)
        .sub_product(t130, t828).sub_product(t132, t826);
    let t833 = (t819 * t111).sub_product(t113, t832).sub_product(t114, t831).add_product(t115, t830)
        .sub_product(t117, t829).sub_product(t119, t828).sub_product(t121, t826);
    let t834 = (t818 * t100).sub_product(t102, t833).sub_product(t104, t832).sub_product(t106, t829)
        .sub_product(t108, t828).sub_product(t110, t826);
    let t835 = (t817 * t87).sub_product(t89, t834).add_product(t91, t833).sub_product(t93, t832)
        .sub_product(t95, t829).sub_product(t97, t828).sub_product(t99, t826);
    let t836 = (-(t78 * t834)).sub_product(t76, t835).sub_product(t81, t829).sub_product(t84, t828)
        .sub_product(t86, t826);
    let t837 = (-(t64 * t835)).sub_product(t62, t836).sub_product(t65, t834).sub_product(t68, t829)
        .add_product(t70, t828).sub_product(t72, t826);
    let t838 = (-(t55 * t836)).sub_product(t53, t837).sub_product(t57, t826);
    let t839 = (-(t45 * t837)).sub_product(t43, t838).sub_product(t43, t836).add_product(t47, t826);
    let drum_v_y_dot_by_rod_v_x = (t38 * t827).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t827);
    let drum_v_x_dot_by_rod_v_x = (t37 * t827).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t827);
    let bobbin_v_y_dot_by_rod_v_x = (-(t36 * t827)).sub_product(c.inverse_bobbin_mass, t828);
    let bobbin_v_x_dot_by_rod_v_x = (-(t35 * t827)).sub_product(c.inverse_bobbin_mass, t829);
    let rod_omega_dot_by_rod_v_x = (t33 * t831).sub_product(R::literal(4_166.666_666_666_667), t833)
        .sub_product(t34, t830);
    let rod_v_y_dot_by_rod_v_x = t730.sub_product(t32, t832).sub_product(R::literal(5.0), t830);
    let rod_v_x_dot_by_rod_v_x = (-t727).add_product(t31, t832).sub_product(R::literal(5.0), t831);
    let cylinder_omega_dot_by_rod_v_x = (-t735).sub_product(t28, t835).add_product(t29, t834)
        .sub_product(R::literal(-2_777.777_777_777_778), t833).add_product(t30, t832);
    let cylinder_v_y_dot_by_rod_v_x = t715.sub_product(R::literal(3.333_333_333_333_333_5), t834)
        .add_product(t27, t832);
    let cylinder_v_x_dot_by_rod_v_x = t712.sub_product(R::literal(3.333_333_333_333_333_5), t835)
        .sub_product(t26, t832);
    let plate_omega_dot_by_rod_v_x = (t23 * t836).sub_product(t22, t837).sub_product(t22, t835)
        .add_product(t23, t834).add_product(t24, t829).sub_product(t25, t828);
    let plate_v_y_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t834))
        .sub_product(R::literal(0.833_333_333_333_333_4), t836)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t828);
    let plate_v_x_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t835))
        .sub_product(R::literal(0.833_333_333_333_333_4), t837)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t829);
    let post_omega_dot_by_rod_v_x = (t20 * t838).sub_product(t19, t839).sub_product(t19, t837)
        .add_product(t20, t836).sub_product(t21, t826);
    let post_v_y_dot_by_rod_v_x = (-(R::literal(-1.25) * t836)).sub_product(R::literal(1.25), t838);
    let post_v_x_dot_by_rod_v_x = (-(R::literal(-1.25) * t837)).sub_product(R::literal(1.25), t839);
    let t840 = t753 - t715;
    let t841 = (t756 - t757).sub_product(t89, t840);
    let t842 = t759.add_product(t91, t840).sub_product(t102, t841);
    let t843 = (t752 - t761 + t762 - t763 - t764 + t765).sub_product(t93, t840).sub_product(t104,
        t841).sub_product(t113, t842);
    let t844 = t729.sub_product(t114, t842).sub_product(t124, t843);
    let t845 = t768.add_product(t115, t842).sub_product(t126, t843).sub_product(t135, t844);
    let t846 = (-(t95 * t840)).sub_product(t106, t841).sub_product(t117, t842).sub_product(t128,
        t843).sub_product(t137, t844).sub_product(t144, t845);
    let t847 = (-(t97 * t840)).sub_product(t108, t841).sub_product(t119, t842).sub_product(t130,
        t843).sub_product(t139, t844).sub_product(t146, t845).sub_product(t151, t846);
    let t848 = (t152 * t846).sub_product(t157, t847);
    let t849 = (-(t99 * t840)).sub_product(t110, t841).sub_product(t121, t842).sub_product(t132,
        t843).sub_product(t141, t844).sub_product(t148, t845).sub_product(t154, t846)
        .sub_product(t159, t847).sub_product(t164, t848) * t165;
    let t850 = (t848 * t162).sub_product(t164, t849);
    let t851 = (t847 * t155).sub_product(t157, t850).sub_product(t159, t849);
    let t852 = (t846 * t149).sub_product(t151, t851).add_product(t152, t850).sub_product(t154,
        t849);
    let t853 = (t845 * t142).sub_product(t144, t852).sub_product(t146, t851).sub_product(t148,
        t849);
    let t854 = (t844 * t133).sub_product(t135, t853).sub_product(t137, t852).sub_product(t139, t851)
        .sub_product(t141, t849);
    let t855 = (t843 * t122).sub_product(t124, t854).sub_product(t126, t853).sub_product(t128, t852)
        .sub_product(t130, t851).sub_product(t132, t849);
    let t856 = (t842 * t111).sub_product(t113, t855).sub_product(t114, t854).add_product(t115, t853)
        .sub_product(t117, t852).sub_product(t119, t851).sub_product(t121, t849);
    let t857 = (t841 * t100).sub_product(t102, t856).sub_product(t104, t855).sub_product(t106, t852)
        .sub_product(t108, t851).sub_product(t110, t849);
    let t858 = (t840 * t87).sub_product(t89, t857).add_product(t91, t856).sub_product(t93, t855)
        .sub_product(t95, t852).sub_product(t97, t851).sub_product(t99, t849);
    let t859 = (-(t78 * t857)).sub_product(t76, t858).sub_product(t81, t852).sub_product(t84, t851)
        .sub_product(t86, t849);
    let t860 = (-(t64 * t858)).sub_product(t62, t859).sub_product(t65, t857).sub_product(t68, t852)
        .add_product(t70, t851).sub_product(t72, t849);
    let t861 = (-(t55 * t859)).sub_product(t53, t860).sub_product(t57, t849);
    let t862 = (-(t45 * t860)).sub_product(t43, t861).sub_product(t43, t859).add_product(t47, t849);
    let drum_v_y_dot_by_rod_v_y = (t38 * t850).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t850);
    let drum_v_x_dot_by_rod_v_y = (t37 * t850).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t850);
    let bobbin_v_y_dot_by_rod_v_y = (-(t36 * t850)).sub_product(c.inverse_bobbin_mass, t851);
    let bobbin_v_x_dot_by_rod_v_y = (-(t35 * t850)).sub_product(c.inverse_bobbin_mass, t852);
    let rod_omega_dot_by_rod_v_y = (t33 * t854).sub_product(R::literal(4_166.666_666_666_667), t856)
        .sub_product(t34, t853);
    let rod_v_y_dot_by_rod_v_y = (-t768).sub_product(t32, t855).sub_product(R::literal(5.0), t853);
    let rod_v_x_dot_by_rod_v_y = (-t729).add_product(t31, t855).sub_product(R::literal(5.0), t854);
    let cylinder_omega_dot_by_rod_v_y = (-t773).sub_product(t28, t858).add_product(t29, t857)
        .sub_product(R::literal(-2_777.777_777_777_778), t856).add_product(t30, t855);
    let cylinder_v_y_dot_by_rod_v_y = t755.sub_product(R::literal(3.333_333_333_333_333_5), t857)
        .add_product(t27, t855);
    let cylinder_v_x_dot_by_rod_v_y = t715.sub_product(R::literal(3.333_333_333_333_333_5), t858)
        .sub_product(t26, t855);
    let plate_omega_dot_by_rod_v_y = (t23 * t859).sub_product(t22, t860).sub_product(t22, t858)
        .add_product(t23, t857).add_product(t24, t852).sub_product(t25, t851);
    let plate_v_y_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t857))
        .sub_product(R::literal(0.833_333_333_333_333_4), t859)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t851);
    let plate_v_x_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t858))
        .sub_product(R::literal(0.833_333_333_333_333_4), t860)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t852);
    let post_omega_dot_by_rod_v_y = (t20 * t861).sub_product(t19, t862).sub_product(t19, t860)
        .add_product(t20, t859).sub_product(t21, t849);
    let post_v_y_dot_by_rod_v_y = (-(R::literal(-1.25) * t859)).sub_product(R::literal(1.25), t861);
    let post_v_x_dot_by_rod_v_y = (-(R::literal(-1.25) * t860)).sub_product(R::literal(1.25), t862);
    let t863 = R::literal(0.12) * rod_omega;
    let t864 = t863 * cos_rod_phi;
    let t865 = (t863 * sin_rod_phi).sub_product(t135, t864);
    let t866 = (-(t137 * t864)).sub_product(t144, t865);
    let t867 = (-(t139 * t864)).sub_product(t146, t865).sub_product(t151, t866);
    let t868 = (t152 * t866).sub_product(t157, t867);
    let t869 = (-(t141 * t864)).sub_product(t148, t865).sub_product(t154, t866).sub_product(t159,
        t867).sub_product(t164, t868) * t165;
    let t870 = (t868 * t162).sub_product(t164, t869);
    let t871 = (t867 * t155).sub_product(t157, t870).sub_product(t159, t869);
    let t872 = (t866 * t149).sub_product(t151, t871).add_product(t152, t870).sub_product(t154,
        t869);
    let t873 = (t865 * t142).sub_product(t144, t872).sub_product(t146, t871).sub_product(t148,
        t869);
    let t874 = (t864 * t133).sub_product(t135, t873).sub_product(t137, t872).sub_product(t139, t871)
        .sub_product(t141, t869);
    let t875 = (-(t126 * t873)).sub_product(t124, t874).sub_product(t128, t872).sub_product(t130,
        t871).sub_product(t132, t869);
    let t876 = (-(t114 * t874)).sub_product(t113, t875).add_product(t115, t873).sub_product(t117,
        t872).sub_product(t119, t871).sub_product(t121, t869);
    let t877 = (-(t104 * t875)).sub_product(t102, t876).sub_product(t106, t872).sub_product(t108,
        t871).sub_product(t110, t869);
    let t878 = (t91 * t876).sub_product(t89, t877).sub_product(t93, t875).sub_product(t95, t872)
        .sub_product(t97, t871).sub_product(t99, t869);
    let t879 = (-(t78 * t877)).sub_product(t76, t878).sub_product(t81, t872).sub_product(t84, t871)
        .sub_product(t86, t869);
    let t880 = (-(t64 * t878)).sub_product(t62, t879).sub_product(t65, t877).sub_product(t68, t872)
        .add_product(t70, t871).sub_product(t72, t869);
    let t881 = (-(t55 * t879)).sub_product(t53, t880).sub_product(t57, t869);
    let t882 = (-(t45 * t880)).sub_product(t43, t881).sub_product(t43, t879).add_product(t47, t869);
    let drum_v_y_dot_by_rod_omega = (t38 * t870).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t870);
    let drum_v_x_dot_by_rod_omega = (t37 * t870).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t870);
    let bobbin_v_y_dot_by_rod_omega = (-(t36 * t870)).sub_product(c.inverse_bobbin_mass, t871);
    let bobbin_v_x_dot_by_rod_omega = (-(t35 * t870)).sub_product(c.inverse_bobbin_mass, t872);
    let rod_omega_dot_by_rod_omega = (t33 * t874).sub_product(R::literal(4_166.666_666_666_667),
        t876).sub_product(t34, t873);
    let rod_v_y_dot_by_rod_omega = (-(R::literal(5.0) * t873)).sub_product(t32, t875);
    let rod_v_x_dot_by_rod_omega = (-(R::literal(5.0) * t874)).add_product(t31, t875);
    let cylinder_omega_dot_by_rod_omega = (t29 * t877).sub_product(t28, t878)
        .sub_product(R::literal(-2_777.777_777_777_778), t876).add_product(t30, t875);
    let cylinder_v_y_dot_by_rod_omega = (t27 * t875)
        .sub_product(R::literal(3.333_333_333_333_333_5), t877);
    let cylinder_v_x_dot_by_rod_omega = (-(t26 * t875))
        .sub_product(R::literal(3.333_333_333_333_333_5), t878);
    let plate_omega_dot_by_rod_omega = (t23 * t879).sub_product(t22, t880).sub_product(t22, t878)
        .add_product(t23, t877).add_product(t24, t872).sub_product(t25, t871);
    let plate_v_y_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t877))
        .sub_product(R::literal(0.833_333_333_333_333_4), t879)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t871);
    let plate_v_x_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t878))
        .sub_product(R::literal(0.833_333_333_333_333_4), t880)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t872);
    let post_omega_dot_by_rod_omega = (t20 * t881).sub_product(t19, t882).sub_product(t19, t880)
        .add_product(t20, t879).sub_product(t21, t869);
    let post_v_y_dot_by_rod_omega = (-(R::literal(-1.25) * t879)).sub_product(R::literal(1.25),
        t881);
    let post_v_x_dot_by_rod_omega = (-(R::literal(-1.25) * t880)).sub_product(R::literal(1.25),
        t882);
    let t883 = R::literal(2.0) * bobbin_x * drum_x;
    let bobbin_x_times_bobbin_y = bobbin_x * bobbin_y;
    let bobbin_x_times_drum_y = bobbin_x * drum_y;
    let bobbin_y_times_drum_x = bobbin_y * drum_x;
    let drum_x_times_drum_y = drum_x * drum_y;
    let bobbin_x_squared = bobbin_x * bobbin_x;
    let drum_x_squared = drum_x * drum_x;
    let t884 = R::literal(2.0) * (bobbin_x_times_bobbin_y * bobbin_v_y).add_product(t883, drum_v_x)
        .add_product(bobbin_x_times_drum_y, drum_v_y).add_product(bobbin_y_times_drum_x, drum_v_y)
        .add_product(drum_x_times_drum_y, bobbin_v_y).add_product(bobbin_v_x, bobbin_x_squared)
        .add_product(bobbin_v_x, drum_x_squared).add_product(drum_v_x, between_squared)
        .sub_product(t883, bobbin_v_x).sub_product(bobbin_x_times_bobbin_y, drum_v_y)
        .sub_product(bobbin_x_times_drum_y, bobbin_v_y).sub_product(bobbin_y_times_drum_x,
        bobbin_v_y).sub_product(drum_x_times_drum_y, drum_v_y).sub_product(bobbin_v_x,
        between_squared).sub_product(drum_v_x, bobbin_x_squared).sub_product(drum_v_x,
        drum_x_squared) / between_squared_times_between;
    let t885 = t884 * t162;
    let t886 = t164 * t884 * t165;
    let t887 = t164 * t886;
    let t888 = t885 + t887;
    let t889 = t159 * t886;
    let t890 = t889.sub_product(t157, t888);
    let t891 = t154 * t886;
    let t892 = (t152 * t888).sub_product(t151, t890) + t891;
    let t893 = t148 * t886;
    let t894 = (-(t146 * t890)).sub_product(t144, t892) + t893;
    let t895 = t141 * t886;
    let t896 = (-(t137 * t892)).sub_product(t135, t894).sub_product(t139, t890) + t895;
    let t897 = t132 * t886;
    let t898 = (-(t126 * t894)).sub_product(t124, t896).sub_product(t128, t892).sub_product(t130,
        t890) + t897;
    let t899 = t121 * t886;
    let t900 = (-(t114 * t896)).sub_product(t113, t898).add_product(t115, t894).sub_product(t117,
        t892).sub_product(t119, t890) + t899;
    let t901 = t110 * t886;
    let t902 = (-(t104 * t898)).sub_product(t102, t900).sub_product(t106, t892).sub_product(t108,
        t890) + t901;
    let t903 = t99 * t886;
    let t904 = (t91 * t900).sub_product(t89, t902).sub_product(t93, t898).sub_product(t95, t892)
        .sub_product(t97, t890) + t903;
    let t905 = t86 * t886;
    let t906 = (-(t78 * t902)).sub_product(t76, t904).sub_product(t81, t892).sub_product(t84, t890)
        + t905;
    let t907 = t72 * t886;
    let t908 = (-(t64 * t904)).sub_product(t62, t906).sub_product(t65, t902).sub_product(t68, t892)
        .add_product(t70, t890) + t907;
    let t909 = t57 * t886;
    let t910 = (-(t55 * t906)).sub_product(t53, t908) + t909;
    let t911 = t47 * t886;
    let t912 = (-(t45 * t908)).sub_product(t43, t910).sub_product(t43, t906) - t911;
    let drum_v_y_dot_by_bobbin_v_x = (t38 * t888).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t888);
    let drum_v_x_dot_by_bobbin_v_x = (t37 * t888).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t888);
    let bobbin_v_y_dot_by_bobbin_v_x = (-(t36 * t888)).sub_product(c.inverse_bobbin_mass, t890);
    let bobbin_v_x_dot_by_bobbin_v_x = (-(t35 * t888)).sub_product(c.inverse_bobbin_mass, t892);
    let rod_omega_dot_by_bobbin_v_x = (t33 * t896).sub_product(R::literal(4_166.666_666_666_667),
        t900).sub_product(t34, t894);
    let rod_v_y_dot_by_bobbin_v_x = (-(R::literal(5.0) * t894)).sub_product(t32, t898);
    let rod_v_x_dot_by_bobbin_v_x = (-(R::literal(5.0) * t896)).add_product(t31, t898);
    let cylinder_omega_dot_by_bobbin_v_x = (t29 * t902).sub_product(t28, t904)
        .sub_product(R::literal(-2_777.777_777_777_778), t900).add_product(t30, t898);
    let cylinder_v_y_dot_by_bobbin_v_x = (t27 * t898)
        .sub_product(R::literal(3.333_333_333_333_333_5), t902);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(t26 * t898))
        .sub_product(R::literal(3.333_333_333_333_333_5), t904);
    let plate_omega_dot_by_bobbin_v_x = (t23 * t906).sub_product(t22, t908).sub_product(t22, t904)
        .add_product(t23, t902).add_product(t24, t892).sub_product(t25, t890);
    let plate_v_y_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t902))
        .sub_product(R::literal(0.833_333_333_333_333_4), t906)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t890);
    let plate_v_x_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t904))
        .sub_product(R::literal(0.833_333_333_333_333_4), t908)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t892);
    let t913 = t21 * t886;
    let post_omega_dot_by_bobbin_v_x = (t20 * t910).sub_product(t19, t912).sub_product(t19, t908)
        .add_product(t20, t906) + t913;
    let post_v_y_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t906)).sub_product(R::literal(1.25),
        t910);
    let post_v_x_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t908)).sub_product(R::literal(1.25),
        t912);
    let t914 = R::literal(2.0) * bobbin_y * drum_y;
    let bobbin_y_squared = bobbin_y * bobbin_y;
    let drum_y_squared = drum_y * drum_y;
    let t915 = R::literal(2.0) * (bobbin_x_times_bobbin_y * bobbin_v_x).add_product(t914, drum_v_y)
        .add_product(bobbin_x_times_drum_y, drum_v_x).add_product(bobbin_y_times_drum_x, drum_v_x)
        .add_product(drum_x_times_drum_y, bobbin_v_x).add_product(bobbin_v_y, bobbin_y_squared)
        .add_product(bobbin_v_y, drum_y_squared).add_product(drum_v_y, between_squared)
        .sub_product(t914, bobbin_v_y).sub_product(bobbin_x_times_bobbin_y, drum_v_x)
        .sub_product(bobbin_x_times_drum_y, bobbin_v_x).sub_product(bobbin_y_times_drum_x,
        bobbin_v_x).sub_product(drum_x_times_drum_y, drum_v_x).sub_product(bobbin_v_y,
        between_squared).sub_product(drum_v_y, bobbin_y_squared).sub_product(drum_v_y,
        drum_y_squared) / between_squared_times_between;
    let t916 = t915 * t162;
    let t917 = t164 * t915 * t165;
    let t918 = t164 * t917;
    let t919 = t916 + t918;
    let t920 = t159 * t917;
    let t921 = t920.sub_product(t157, t919);
    let t922 = t154 * t917;
    let t923 = (t152 * t919).sub_product(t151, t921) + t922;
    let t924 = t148 * t917;
    let t925 = (-(t146 * t921)).sub_product(t144, t923) + t924;
    let t926 = t141 * t917;
    let t927 = (-(t137 * t923)).sub_product(t135, t925).sub_product(t139, t921) + t926;
    let t928 = t132 * t917;
    let t929 = (-(t126 * t925)).sub_product(t124, t927).sub_product(t128, t923).sub_product(t130,
        t921) + t928;
    let t930 = t121 * t917;
    let t931 = (-(t114 * t927)).sub_product(t113, t929).add_product(t115, t925).sub_product(t117,
        t923).sub_product(t119, t921) + t930;
    let t932 = t110 * t917;
    let t933 = (-(t104 * t929)).sub_product(t102, t931).sub_product(t106, t923).sub_product(t108,
        t921) + t932;
    let t934 = t99 * t917;
    let t935 = (t91 * t931).sub_product(t89, t933).sub_product(t93, t929).sub_product(t95, t923)
        .sub_product(t97, t921) + t934;
    let t936 = t86 * t917;
    let t937 = (-(t78 * t933)).sub_product(t76, t935).sub_product(t81, t923).sub_product(t84, t921)
        + t936;
    let t938 = t72 * t917;
    let t939 = (-(t64 * t935)).sub_product(t62, t937).sub_product(t65, t933).sub_product(t68, t923)
        .add_product(t70, t921) + t938;
    let t940 = t57 * t917;
    let t941 = (-(t55 * t937)).sub_product(t53, t939) + t940;
    let t942 = t47 * t917;
    let t943 = (-(t45 * t939)).sub_product(t43, t941).sub_product(t43, t937) - t942;
    let drum_v_y_dot_by_bobbin_v_y = (t38 * t919).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t919);
    let drum_v_x_dot_by_bobbin_v_y = (t37 * t919).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t919);
    let bobbin_v_y_dot_by_bobbin_v_y = (-(t36 * t919)).sub_product(c.inverse_bobbin_mass, t921);
    let bobbin_v_x_dot_by_bobbin_v_y = (-(t35 * t919)).sub_product(c.inverse_bobbin_mass, t923);
    let rod_omega_dot_by_bobbin_v_y = (t33 * t927).sub_product(R::literal(4_166.666_666_666_667),
        t931).sub_product(t34, t925);
    let rod_v_y_dot_by_bobbin_v_y = (-(R::literal(5.0) * t925)).sub_product(t32, t929);
    let rod_v_x_dot_by_bobbin_v_y = (-(R::literal(5.0) * t927)).add_product(t31, t929);
    let cylinder_omega_dot_by_bobbin_v_y = (t29 * t933).sub_product(t28, t935)
        .sub_product(R::literal(-2_777.777_777_777_778), t931).add_product(t30, t929);
    let cylinder_v_y_dot_by_bobbin_v_y = (t27 * t929)
        .sub_product(R::literal(3.333_333_333_333_333_5), t933);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(t26 * t929))
        .sub_product(R::literal(3.333_333_333_333_333_5), t935);
    let plate_omega_dot_by_bobbin_v_y = (t23 * t937).sub_product(t22, t939).sub_product(t22, t935)
        .add_product(t23, t933).add_product(t24, t923).sub_product(t25, t921);
    let plate_v_y_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t933))
        .sub_product(R::literal(0.833_333_333_333_333_4), t937)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t921);
    let plate_v_x_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t935))
        .sub_product(R::literal(0.833_333_333_333_333_4), t939)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t923);
    let t944 = t21 * t917;
    let post_omega_dot_by_bobbin_v_y = (t20 * t941).sub_product(t19, t943).sub_product(t19, t939)
        .add_product(t20, t937) + t944;
    let post_v_y_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t937)).sub_product(R::literal(1.25),
        t941);
    let post_v_x_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t939)).sub_product(R::literal(1.25),
        t943);
    let t945 = -t885 - t887;
    let t946 = (-t889).sub_product(t157, t945);
    let t947 = (t152 * t945).sub_product(t151, t946) - t891;
    let t948 = (-(t146 * t946)).sub_product(t144, t947) - t893;
    let t949 = (-(t137 * t947)).sub_product(t135, t948).sub_product(t139, t946) - t895;
    let t950 = (-(t126 * t948)).sub_product(t124, t949).sub_product(t128, t947).sub_product(t130,
        t946) - t897;
    let t951 = (-(t114 * t949)).sub_product(t113, t950).add_product(t115, t948).sub_product(t117,
        t947).sub_product(t119, t946) - t899;
    let t952 = (-(t104 * t950)).sub_product(t102, t951).sub_product(t106, t947).sub_product(t108,
        t946) - t901;
    let t953 = (t91 * t951).sub_product(t89, t952).sub_product(t93, t950).sub_product(t95, t947)
        .sub_product(t97, t946) - t903;
    let t954 = (-(t78 * t952)).sub_product(t76, t953).sub_product(t81, t947).sub_product(t84, t946)
        - t905;
    let t955 = (-(t64 * t953)).sub_product(t62, t954).sub_product(t65, t952).sub_product(t68, t947)
        .add_product(t70, t946) - t907;
    let t956 = (-(t55 * t954)).sub_product(t53, t955) - t909;
    let t957 = (-(t45 * t955)).sub_product(t43, t956).sub_product(t43, t954) + t911;
    let drum_v_y_dot_by_drum_v_x = (t38 * t945).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t945);
    let drum_v_x_dot_by_drum_v_x = (t37 * t945).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t945);
    let bobbin_v_y_dot_by_drum_v_x = (-(t36 * t945)).sub_product(c.inverse_bobbin_mass, t946);
    let bobbin_v_x_dot_by_drum_v_x = (-(t35 * t945)).sub_product(c.inverse_bobbin_mass, t947);
    let rod_omega_dot_by_drum_v_x = (t33 * t949).sub_product(R::literal(4_166.666_666_666_667),
        t951).sub_product(t34, t948);
    let rod_v_y_dot_by_drum_v_x = (-(R::literal(5.0) * t948)).sub_product(t32, t950);
    let rod_v_x_dot_by_drum_v_x = (-(R::literal(5.0) * t949)).add_product(t31, t950);
    let cylinder_omega_dot_by_drum_v_x = (t29 * t952).sub_product(t28, t953)
        .sub_product(R::literal(-2_777.777_777_777_778), t951).add_product(t30, t950);
    let cylinder_v_y_dot_by_drum_v_x = (t27 * t950)
        .sub_product(R::literal(3.333_333_333_333_333_5), t952);
    let cylinder_v_x_dot_by_drum_v_x = (-(t26 * t950))
        .sub_product(R::literal(3.333_333_333_333_333_5), t953);
    let plate_omega_dot_by_drum_v_x = (t23 * t954).sub_product(t22, t955).sub_product(t22, t953)
        .add_product(t23, t952).add_product(t24, t947).sub_product(t25, t946);
    let plate_v_y_dot_by_drum_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t952))
        .sub_product(R::literal(0.833_333_333_333_333_4), t954)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t946);
    let plate_v_x_dot_by_drum_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t953))
        .sub_product(R::literal(0.833_333_333_333_333_4), t955)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t947);
    let post_omega_dot_by_drum_v_x = (t20 * t956).sub_product(t19, t957).sub_product(t19, t955)
        .add_product(t20, t954) - t913;
    let post_v_y_dot_by_drum_v_x = (-(R::literal(-1.25) * t954)).sub_product(R::literal(1.25),
        t956);
    let post_v_x_dot_by_drum_v_x = (-(R::literal(-1.25) * t955)).sub_product(R::literal(1.25),
        t957);
    let t958 = -t916 - t918;
    let t959 = (-t920).sub_product(t157, t958);
    let t960 = (t152 * t958).sub_product(t151, t959) - t922;
    let t961 = (-(t146 * t959)).sub_product(t144, t960) - t924;
    let t962 = (-(t137 * t960)).sub_product(t135, t961).sub_product(t139, t959) - t926;
    let t963 = (-(t126 * t961)).sub_product(t124, t962).sub_product(t128, t960).sub_product(t130,
        t959) - t928;
    let t964 = (-(t114 * t962)).sub_product(t113, t963).add_product(t115, t961).sub_product(t117,
        t960).sub_product(t119, t959) - t930;
    let t965 = (-(t104 * t963)).sub_product(t102, t964).sub_product(t106, t960).sub_product(t108,
        t959) - t932;
    let t966 = (t91 * t964).sub_product(t89, t965).sub_product(t93, t963).sub_product(t95, t960)
        .sub_product(t97, t959) - t934;
    let t967 = (-(t78 * t965)).sub_product(t76, t966).sub_product(t81, t960).sub_product(t84, t959)
        - t936;
    let t968 = (-(t64 * t966)).sub_product(t62, t967).sub_product(t65, t965).sub_product(t68, t960)
        .add_product(t70, t959) - t938;
    let t969 = (-(t55 * t967)).sub_product(t53, t968) - t940;
    let t970 = (-(t45 * t968)).sub_product(t43, t969).sub_product(t43, t967) + t942;
    let drum_v_y_dot_by_drum_v_y = (t38 * t958).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t958);
    let drum_v_x_dot_by_drum_v_y = (t37 * t958).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t958);
    let bobbin_v_y_dot_by_drum_v_y = (-(t36 * t958)).sub_product(c.inverse_bobbin_mass, t959);
    let bobbin_v_x_dot_by_drum_v_y = (-(t35 * t958)).sub_product(c.inverse_bobbin_mass, t960);
    let rod_omega_dot_by_drum_v_y = (t33 * t962).sub_product(R::literal(4_166.666_666_666_667),
        t964).sub_product(t34, t961);
    let rod_v_y_dot_by_drum_v_y = (-(R::literal(5.0) * t961)).sub_product(t32, t963);
    let rod_v_x_dot_by_drum_v_y = (-(R::literal(5.0) * t962)).add_product(t31, t963);
    let cylinder_omega_dot_by_drum_v_y = (t29 * t965).sub_product(t28, t966)
        .sub_product(R::literal(-2_777.777_777_777_778), t964).add_product(t30, t963);
    let cylinder_v_y_dot_by_drum_v_y = (t27 * t963)
        .sub_product(R::literal(3.333_333_333_333_333_5), t965);
    let cylinder_v_x_dot_by_drum_v_y = (-(t26 * t963))
        .sub_product(R::literal(3.333_333_333_333_333_5), t966);
    let plate_omega_dot_by_drum_v_y = (t23 * t967).sub_product(t22, t968).sub_product(t22, t966)
        .add_product(t23, t965).add_product(t24, t960).sub_product(t25, t959);
    let plate_v_y_dot_by_drum_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t965))
        .sub_product(R::literal(0.833_333_333_333_333_4), t967)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t959);
    let plate_v_x_dot_by_drum_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t966))
        .sub_product(R::literal(0.833_333_333_333_333_4), t968)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t960);
    let post_omega_dot_by_drum_v_y = (t20 * t969).sub_product(t19, t970).sub_product(t19, t968)
        .add_product(t20, t967) - t944;
    let post_v_y_dot_by_drum_v_y = (-(R::literal(-1.25) * t967)).sub_product(R::literal(1.25),
        t969);
    let post_v_x_dot_by_drum_v_y = (-(R::literal(-1.25) * t968)).sub_product(R::literal(1.25),
        t970);
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

/// `dy'/dp`, values in the order of its pattern. 2220 operations.
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
    let t32 = R::literal(-1.25) - t31;
    let t33 = R::literal(1.0) / t32;
    let t34 = t12 * t1;
    let t35 = t34 * t33;
    let t36 = R::literal(1.25) - t31;
    let t37 = t36 * t33;
    let t38 = t13 * t1;
    let t39 = t38 * t33;
    let t40 = t12 * t0;
    let t41 = R::literal(-1.25) - t40;
    let t42 = t35 * t34;
    let t43 = R::literal(1.0) / (t41 - t42);
    let t44 = (t11 * t0).sub_product(t37, t34);
    let t45 = t44 * t43;
    let t46 = R::literal(1.25) - t40 - t42;
    let t47 = t46 * t43;
    let t48 = (t13 * t0).add_product(t39, t34);
    let t49 = t48 * t43;
    let t50 = t14 * t3;
    let t51 = R::literal(1.0) / (t32 - R::literal(0.833_333_333_333_333_4) - t50).sub_product(t37,
        t36).sub_product(t45, t44);
    let t52 = t15 * t3;
    let t53 = (t34 + t52).sub_product(t35, t36).sub_product(t47, t44);
    let t54 = t53 * t51;
    let t55 = R::literal(0.833_333_333_333_333_4) - t50;
    let t56 = t55 * t51;
    let t57 = t52 * t51;
    let t58 = t16 * t3;
    let t59 = R::literal(0.833_333_333_333_333_4) + t58;
    let t60 = t59 * t51;
    let t61 = t17 * t3;
    let t62 = t61 * t51;
    let t63 = (-t38).add_product(t39, t36).sub_product(t49, t44);
    let t64 = t63 * t51;
    let t65 = t15 * t2;
    let t66 = R::literal(1.0) / (t41 - R::literal(0.833_333_333_333_333_4) - t65 - t42)
        .sub_product(t47, t46).sub_product(t54, t53);
    let t67 = (t14 * t2).sub_product(t56, t53);
    let t68 = t67 * t66;
    let t69 = (R::literal(0.833_333_333_333_333_4) - t65).sub_product(t57, t53);
    let t70 = t69 * t66;
    let t71 = -(t16 * t2);
    let t72 = t71.sub_product(t60, t53);
    let t73 = t72 * t66;
    let t74 = t17 * t2;
    let t75 = (R::literal(0.833_333_333_333_333_4) + t74).add_product(t62, t53);
    let t76 = t75 * t66;
    let t77 = t48.sub_product(t49, t46).sub_product(t64, t53);
    let t78 = t77 * t66;
    let t79 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t50
        - R::literal(3.333_333_333_333_333_5)).sub_product(t20, t5).sub_product(t56, t55)
        .sub_product(t68, t67);
    let t80 = t52.add_product(t21, t5).sub_product(t57, t55).sub_product(t70, t67);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = (-t18).add_product(t22, t5);
    let t85 = t84 * t79;
    let t86 = (R::literal(-0.833_333_333_333_333_4) + t58).sub_product(t60, t55).sub_product(t73,
        t67);
    let t87 = t86 * t79;
    let t88 = (-t61).add_product(t62, t55).sub_product(t76, t67);
    let t89 = t88 * t79;
    let t90 = (-(t64 * t55)).sub_product(t78, t67);
    let t91 = t90 * t79;
    let t92 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t65
        - R::literal(3.333_333_333_333_333_5)).sub_product(t21, t4).sub_product(t57, t52)
        .sub_product(t70, t69).sub_product(t81, t80);
    let t93 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).add_product(t83, t80);
    let t94 = t93 * t92;
    let t95 = t19.sub_product(t22, t4).sub_product(t85, t80);
    let t96 = t95 * t92;
    let t97 = t71.sub_product(t60, t52).sub_product(t73, t69).sub_product(t87, t80);
    let t98 = t97 * t92;
    let t99 = (R::literal(-0.833_333_333_333_333_4) + t74).add_product(t62, t52).sub_product(t76,
        t69).sub_product(t89, t80);
    let t100 = t99 * t92;
    let t101 = (-(t64 * t52)).sub_product(t78, t69).sub_product(t91, t80);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).sub_product(t83, t82)
        .sub_product(t94, t93);
    let t104 = (-t22).add_product(t85, t82).sub_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t25 * t103;
    let t107 = t26 * t103;
    let t108 = (t87 * t82).sub_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t82).sub_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t82).sub_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t19 * cos_cylinder_phi)).sub_product(t18, sin_cylinder_phi)
        .sub_product(t22, slide).sub_product(t23, sin_cylinder_phi).sub_product(t24,
        cos_cylinder_phi).sub_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t23.sub_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = (-t24).add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (-(t87 * t84)).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (-(t89 * t84)).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (-(t91 * t84)).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(-5.0).sub_product(t25, t6).sub_product(t106, t25)
        .sub_product(t116, t115);
    let t126 = (t26 * t6).add_product(t107, t25).sub_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (-(t109 * t25)).sub_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (-(t111 * t25)).sub_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (-(t113 * t25)).sub_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / R::literal(-5.0).sub_product(t26, R::literal(0.06) * cos_rod_phi)
        .sub_product(t107, t26).sub_product(t118, t117).sub_product(t127, t126);
    let t135 = (t109 * t26).sub_product(t120, t117).sub_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (t111 * t26).sub_product(t122, t117).sub_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (t113 * t26).sub_product(t124, t117).sub_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t16, t9)
        - inverse_bobbin_mass).sub_product(t60, t59).sub_product(t73, t72).sub_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).sub_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t17 * t9).add_product(t62, t59).sub_product(t76, t72).sub_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).sub_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t27 * t141;
    let t145 = (-(t64 * t59)).sub_product(t78, t72).sub_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).sub_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
        - inverse_bobbin_mass).sub_product(t62, t61).sub_product(t76, t75).sub_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).sub_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t28).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (t64 * t61).sub_product(t78, t75).sub_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).sub_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t29 * bobbin_x_minus_drum_x_over_between;
    let t153 = t30 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (((-(t28 * bobbin_y_minus_drum_y_over_between)).sub_product(t27,
        bobbin_x_minus_drum_x_over_between) - t152 - t153).sub_product(t144, t27).sub_product(t149,
        t148) + t152 + t153);
    let t155 = (t146 * t27).sub_product(t151, t148);
    let t156 = t155 * t154;
    let t157 = R::literal(1.0) / (-(t13 * t8)).sub_product(t39, t38).sub_product(t49, t48)
        .sub_product(t64, t63).sub_product(t78, t77).sub_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).sub_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t158 = R::literal(50.0) * slide_rate;
    let t159 = t158 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t160 = p.spring_stiffness * slide_minus_spring_free_length;
    let t161 = t160 * cos_cylinder_phi;
    let t162 = t159 + t161;
    let t163 = t160 * sin_cylinder_phi;
    let t164 = t158 * sin_cylinder_phi;
    let t165 = t164 - (R::literal(2.943) - t163);
    let t166 = (-(t160 * t7)).sub_product(t158, t7);
    let t167 = -t159 - t161;
    let t168 = -t164 - (R::literal(1.962) + t163);
    let t169 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t170 = (p.winding_force * bobbin_x_minus_drum_x / between).sub_product(R::literal(9.81),
        p.bobbin_mass);
    let post_omega_squared = post_omega * post_omega;
    let t171 = R::literal(0.1) * post_omega_squared;
    let t172 = t171 * cos_post_phi;
    let t173 = t171 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t174 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t175 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t176 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t177 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t178 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t179 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t180 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t181 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t182 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t183 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t184 = (bobbin_v_x * (bobbin_v_x_over_between + t178 + t179 - t176 - t177
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t182 + t183
        - t180 - t181 - drum_v_y_over_between).add_product(drum_v_x, t176 + t177
        + drum_v_x_over_between - bobbin_v_x_over_between - t178 - t179).add_product(drum_v_y, t180
        + t181 + drum_v_y_over_between - bobbin_v_y_over_between - t182 - t183);
    let t185 = t35 * t172;
    let t186 = -t173 - R::literal(-9.81) + t185;
    let t187 = t14 * bobbin_radius_times_winding_force;
    let t188 = (t187 - t172.add_product(t174, cos_plate_phi)).add_product(t37, t172)
        .sub_product(t45, t186);
    let t189 = t15 * bobbin_radius_times_winding_force;
    let t190 = (-t173.add_product(t174, sin_plate_phi) - R::literal(9.81) - R::literal(-9.81)
        - t189 + t185).sub_product(t47, t186).sub_product(t54, t188);
    let t191 = t187.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .sub_product(R::literal(3.333_333_333_333_333_5), t162).sub_product(t20, t166)
        .sub_product(t56, t188).sub_product(t68, t190);
    let t192 = (R::literal(-9.81).sub_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) - t189)
        .sub_product(R::literal(3.333_333_333_333_333_5), t165).add_product(t21, t166)
        .sub_product(t57, t188).sub_product(t70, t190).sub_product(t81, t191);
    let t193 = (-(R::literal(-2_777.777_777_777_778) * t166)).add_product(t83, t191)
        .sub_product(t94, t192);
    let t194 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t162)
        .add_product(t19, t165).add_product(t22, t166).add_product(t23, t167).sub_product(t24, t168)
        .sub_product(t85, t191).sub_product(t96, t192);
    let t195 = t194.sub_product(t105, t193);
    let t196 = (t175 * cos_rod_phi).sub_product(R::literal(5.0), t167).sub_product(t106, t193)
        .sub_product(t116, t195);
    let t197 = (t175 * sin_rod_phi).sub_product(R::literal(5.0), t168).add_product(t107, t193)
        .sub_product(t118, t195).sub_product(t127, t196);
    let t198 = inverse_bobbin_mass * t169;
    let t199 = ((t10 * plate_omega_squared).sub_product(t16, bobbin_radius_times_winding_force)
        + t198).sub_product(t60, t188).sub_product(t73, t190).sub_product(t87, t191)
        .sub_product(t98, t192).sub_product(t109, t193).sub_product(t120, t195).sub_product(t129,
        t196).sub_product(t136, t197);
    let t200 = inverse_bobbin_mass * t170;
    let t201 = (R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        bobbin_radius_times_winding_force) - t200).add_product(t62, t188).sub_product(t76, t190)
        .sub_product(t89, t191).sub_product(t100, t192).sub_product(t111, t193).sub_product(t122,
        t195).sub_product(t131, t196).sub_product(t138, t197).sub_product(t143, t199);
    let t202 = (-t184).add_product(t27, t169).sub_product(t28, t170)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t144, t199).sub_product(t149, t201)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t203 = ((R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi)
        * post_omega_squared).sub_product(t39, t172).sub_product(t49, t186).sub_product(t64, t188)
        .sub_product(t78, t190).sub_product(t91, t191).sub_product(t102, t192).sub_product(t113,
        t193).sub_product(t124, t195).sub_product(t133, t196).sub_product(t140, t197)
        .sub_product(t146, t199).sub_product(t151, t201).sub_product(t156, t202) * t157;
    let t204 = (t202 * t154).sub_product(t156, t203);
    let t205 = (t201 * t147).sub_product(t149, t204).sub_product(t151, t203);
    let bobbin_v_y_dot = t200.sub_product(inverse_bobbin_mass, t205).sub_product(t28, t204);
    let t206 = p.spring_stiffness * cos_cylinder_phi;
    let t207 = p.spring_stiffness * t7;
    let t208 = p.spring_stiffness * sin_cylinder_phi;
    let t209 = t14 * p.winding_force;
    let t210 = -(t15 * p.winding_force);
    let t211 = t210.sub_product(t54, t209);
    let t212 = t209.sub_product(t56, t209).sub_product(t68, t211);
    let t213 = t210.sub_product(t57, t209).sub_product(t70, t211).sub_product(t81, t212);
    let t214 = (t83 * t212).sub_product(t94, t213);
    let t215 = (-(t85 * t212)).sub_product(t96, t213).sub_product(t105, t214);
    let t216 = (-(t106 * t214)).sub_product(t116, t215);
    let t217 = (t107 * t214).sub_product(t118, t215).sub_product(t127, t216);
    let t218 = (-(t16 * p.winding_force)).sub_product(t60, t209).sub_product(t73, t211)
        .sub_product(t87, t212).sub_product(t98, t213).sub_product(t109, t214).sub_product(t120,
        t215).sub_product(t129, t216).sub_product(t136, t217);
    let t219 = (t17 * p.winding_force).add_product(t62, t209).sub_product(t76, t211)
        .sub_product(t89, t212).sub_product(t100, t213).sub_product(t111, t214).sub_product(t122,
        t215).sub_product(t131, t216).sub_product(t138, t217).sub_product(t143, t218);
    let t220 = (t144 * t218).sub_product(t149, t219);
    let t221 = (-(t64 * t209)).sub_product(t78, t211).sub_product(t91, t212).sub_product(t102, t213)
        .sub_product(t113, t214).sub_product(t124, t215).sub_product(t133, t216).sub_product(t140,
        t217).sub_product(t146, t218).sub_product(t151, t219).sub_product(t156, t220) * t157;
    let t222 = (t220 * t154).sub_product(t156, t221);
    let t223 = (t219 * t147).sub_product(t149, t222).sub_product(t151, t221);
    let t224 = (t218 * t141).sub_product(t143, t223).add_product(t144, t222).sub_product(t146,
        t221);
    let t225 = (t217 * t134).sub_product(t136, t224).sub_product(t138, t223).sub_product(t140,
        t221);
    let t226 = (t216 * t125).sub_product(t127, t225).sub_product(t129, t224).sub_product(t131, t223)
        .sub_product(t133, t221);
    let t227 = (t215 * t114).sub_product(t116, t226).sub_product(t118, t225).sub_product(t120, t224)
        .sub_product(t122, t223).sub_product(t124, t221);
    let t228 = (t214 * t103).sub_product(t105, t227).sub_product(t106, t226).add_product(t107, t225)
        .sub_product(t109, t224).sub_product(t111, t223).sub_product(t113, t221);
    let t229 = (t213 * t92).sub_product(t94, t228).sub_product(t96, t227).sub_product(t98, t224)
        .sub_product(t100, t223).sub_product(t102, t221);
    let t230 = (t212 * t79).sub_product(t81, t229).add_product(t83, t228).sub_product(t85, t227)
        .sub_product(t87, t224).sub_product(t89, t223).sub_product(t91, t221);
    let t231 = (t211 * t66).sub_product(t68, t230).sub_product(t70, t229).sub_product(t73, t224)
        .sub_product(t76, t223).sub_product(t78, t221);
    let t232 = (t209 * t51).sub_product(t54, t231).sub_product(t56, t230).sub_product(t57, t229)
        .sub_product(t60, t224).add_product(t62, t223).sub_product(t64, t221);
    let t233 = (-(t47 * t231)).sub_product(t45, t232).sub_product(t49, t221);
    let t234 = (-(t37 * t232)).sub_product(t35, t233).sub_product(t35, t231).add_product(t39, t221);
    let drum_v_y_dot_by_bobbin_radius = (t30 * t222)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t222);
    let drum_v_x_dot_by_bobbin_radius = (t29 * t222)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t222);
    let bobbin_v_y_dot_by_bobbin_radius = (-(t28 * t222)).sub_product(inverse_bobbin_mass, t223);
    let bobbin_v_x_dot_by_bobbin_radius = (-(t27 * t222)).sub_product(inverse_bobbin_mass, t224);
    let rod_omega_dot_by_bobbin_radius = (t25 * t226)
        .sub_product(R::literal(4_166.666_666_666_667), t228).sub_product(t26, t225);
    let rod_v_y_dot_by_bobbin_radius = (-(R::literal(5.0) * t225)).sub_product(t24, t227);
    let rod_v_x_dot_by_bobbin_radius = (-(R::literal(5.0) * t226)).add_product(t23, t227);
    let cylinder_omega_dot_by_bobbin_radius = (t21 * t229).sub_product(t20, t230)
        .sub_product(R::literal(-2_777.777_777_777_778), t228).add_product(t22, t227);
    let cylinder_v_y_dot_by_bobbin_radius = (t19 * t227)
        .sub_product(R::literal(3.333_333_333_333_333_5), t229);
    let cylinder_v_x_dot_by_bobbin_radius = (-(t18 * t227))
        .sub_product(R::literal(3.333_333_333_333_333_5), t230);
    let plate_omega_dot_by_bobbin_radius = (-(p.winding_force * R::literal(400.0)))
        .sub_product(t14, t232).add_product(t15, t231).sub_product(t14, t230).add_product(t15, t229)
        .add_product(t16, t224).sub_product(t17, t223);
    let plate_v_y_dot_by_bobbin_radius = (-(R::literal(-0.833_333_333_333_333_4) * t229))
        .sub_product(R::literal(0.833_333_333_333_333_4), t231)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t223);
    let plate_v_x_dot_by_bobbin_radius = (-(R::literal(-0.833_333_333_333_333_4) * t230))
        .sub_product(R::literal(0.833_333_333_333_333_4), t232)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t224);
    let post_omega_dot_by_bobbin_radius = (t12 * t233).sub_product(t11, t234).sub_product(t11, t232)
        .add_product(t12, t231).sub_product(t13, t221);
    let post_v_y_dot_by_bobbin_radius = (-(R::literal(-1.25) * t231)).sub_product(R::literal(1.25),
        t233);
    let post_v_x_dot_by_bobbin_radius = (-(R::literal(-1.25) * t232)).sub_product(R::literal(1.25),
        t234);
    let t235 = t14 * p.bobbin_radius;
    let t236 = -(t15 * p.bobbin_radius);
    let t237 = t236.sub_product(t54, t235);
    let t238 = t235.sub_product(t56, t235).sub_product(t68, t237);
    let t239 = t236.sub_product(t57, t235).sub_product(t70, t237).sub_product(t81, t238);
    let t240 = (t83 * t238).sub_product(t94, t239);
    let t241 = (-(t85 * t238)).sub_product(t96, t239).sub_product(t105, t240);
    let t242 = (-(t106 * t240)).sub_product(t116, t241);
    let t243 = (t107 * t240).sub_product(t118, t241).sub_product(t127, t242);
    let t244 = t28.sub_product(t16, p.bobbin_radius).sub_product(t60, t235).sub_product(t73, t237)
        .sub_product(t87, t238).sub_product(t98, t239).sub_product(t109, t240).sub_product(t120,
        t241).sub_product(t129, t242).sub_product(t136, t243);
    let t245 = (-t27).add_product(t17, p.bobbin_radius).add_product(t62, t235).sub_product(t76,
        t237).sub_product(t89, t238).sub_product(t100, t239).sub_product(t111, t240)
        .sub_product(t122, t241).sub_product(t131, t242).sub_product(t138, t243).sub_product(t143,
        t244);
    let t246 = (t27 * bobbin_y_minus_drum_y_over_between).sub_product(t28,
        bobbin_x_minus_drum_x_over_between).add_product(t144, t244).sub_product(t149, t245);
    let t247 = (-(t64 * t235)).sub_product(t78, t237).sub_product(t91, t238).sub_product(t102, t239)
        .sub_product(t113, t240).sub_product(t124, t241).sub_product(t133, t242).sub_product(t140,
        t243).sub_product(t146, t244).sub_product(t151, t245).sub_product(t156, t246) * t157;
    let t248 = (t246 * t154).sub_product(t156, t247);
    let t249 = (t245 * t147).sub_product(t149, t248).sub_product(t151, t247);
    let t250 = (t244 * t141).sub_product(t143, t249).add_product(t144, t248).sub_product(t146,
        t247);
    let t251 = (t243 * t134).sub_product(t136, t250).sub_product(t138, t249).sub_product(t140,
        t247);
    let t252 = (t242 * t125).sub_product(t127, t251).sub_product(t129, t250).sub_product(t131, t249)
        .sub_product(t133, t247);
    let t253 = (t241 * t114).sub_product(t116, t252).sub_product(t118, t251).sub_product(t120, t250)
        .sub_product(t122, t249).sub_product(t124, t247);
    let t254 = (t240 * t103).sub_product(t105, t253).sub_product(t106, t252).add_product(t107, t251)
        .sub_product(t109, t250).sub_product(t111, t249).sub_product(t113, t247);
    let t255 = (t239 * t92).sub_product(t94, t254).sub_product(t96, t253).sub_product(t98, t250)
        .sub_product(t100, t249).sub_product(t102, t247);
    let t256 = (t238 * t79).sub_product(t81, t255).add_product(t83, t254).sub_product(t85, t253)
        .sub_product(t87, t250).sub_product(t89, t249).sub_product(t91, t247);
    let t257 = (t237 * t66).sub_product(t68, t256).sub_product(t70, t255).sub_product(t73, t250)
        .sub_product(t76, t249).sub_product(t78, t247);
    let t258 = (t235 * t51).sub_product(t54, t257).sub_product(t56, t256).sub_product(t57, t255)
        .sub_product(t60, t250).add_product(t62, t249).sub_product(t64, t247);
    let t259 = (-(t47 * t257)).sub_product(t45, t258).sub_product(t49, t247);
    let t260 = (-(t37 * t258)).sub_product(t35, t259).sub_product(t35, t257).add_product(t39, t247);
    let drum_v_y_dot_by_winding_force = (t30 * t248)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t248);
    let drum_v_x_dot_by_winding_force = (t29 * t248)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t248);
    let bobbin_v_y_dot_by_winding_force = t27.sub_product(inverse_bobbin_mass, t249)
        .sub_product(t28, t248);
    let bobbin_v_x_dot_by_winding_force = (-t28).sub_product(inverse_bobbin_mass, t250)
        .sub_product(t27, t248);
    let rod_omega_dot_by_winding_force = (t25 * t252)
        .sub_product(R::literal(4_166.666_666_666_667), t254).sub_product(t26, t251);
    let rod_v_y_dot_by_winding_force = (-(R::literal(5.0) * t251)).sub_product(t24, t253);
    let rod_v_x_dot_by_winding_force = (-(R::literal(5.0) * t252)).add_product(t23, t253);
    let cylinder_omega_dot_by_winding_force = (t21 * t255).sub_product(t20, t256)
        .sub_product(R::literal(-2_777.777_777_777_778), t254).add_product(t22, t253);
    let cylinder_v_y_dot_by_winding_force = (t19 * t253)
        .sub_product(R::literal(3.333_333_333_333_333_5), t255);
    let cylinder_v_x_dot_by_winding_force = (-(t18 * t253))
        .sub_product(R::literal(3.333_333_333_333_333_5), t256);
    let plate_omega_dot_by_winding_force = (-(p.bobbin_radius * R::literal(400.0)))
        .sub_product(t14, t258).add_product(t15, t257).sub_product(t14, t256).add_product(t15, t255)
        .add_product(t16, t250).sub_product(t17, t249);
    let plate_v_y_dot_by_winding_force = (-(R::literal(-0.833_333_333_333_333_4) * t255))
        .sub_product(R::literal(0.833_333_333_333_333_4), t257)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t249);
    let plate_v_x_dot_by_winding_force = (-(R::literal(-0.833_333_333_333_333_4) * t256))
        .sub_product(R::literal(0.833_333_333_333_333_4), t258)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t250);
    let post_omega_dot_by_winding_force = (t12 * t259).sub_product(t11, t260).sub_product(t11, t258)
        .add_product(t12, t257).sub_product(t13, t247);
    let post_v_y_dot_by_winding_force = (-(R::literal(-1.25) * t257)).sub_product(R::literal(1.25),
        t259);
    let post_v_x_dot_by_winding_force = (-(R::literal(-1.25) * t258)).sub_product(R::literal(1.25),
        t260);
    let t261 = (-(-t198).sub_product(inverse_bobbin_mass, (t199 * t141).sub_product(t143, t205)
        .add_product(t144, t204).sub_product(t146, t203))).add_product(t27, t204);
    let t262 = R::literal(-9.81) - bobbin_v_y_dot;
    let t263 = inverse_bobbin_mass * t261;
    let t264 = inverse_bobbin_mass * t262;
    let t265 = (-t264).add_product(t143, t263);
    let t266 = (-(t28 * t262)).sub_product(t27, t261).sub_product(t144, t263).sub_product(t149,
        t265);
    let t267 = (t146 * t263).sub_product(t151, t265).sub_product(t156, t266) * t157;
    let t268 = (t266 * t154).sub_product(t156, t267);
    let t269 = (t265 * t147).sub_product(t149, t268).sub_product(t151, t267);
    let t270 = (-(t263 * t141)).sub_product(t143, t269).add_product(t144, t268).sub_product(t146,
        t267);
    let t271 = (-(t138 * t269)).sub_product(t136, t270).sub_product(t140, t267);
    let t272 = (-(t129 * t270)).sub_product(t127, t271).sub_product(t131, t269).sub_product(t133,
        t267);
    let t273 = (-(t118 * t271)).sub_product(t116, t272).sub_product(t120, t270).sub_product(t122,
        t269).sub_product(t124, t267);
    let t274 = (-(t106 * t272)).sub_product(t105, t273).add_product(t107, t271).sub_product(t109,
        t270).sub_product(t111, t269).sub_product(t113, t267);
    let t275 = (-(t96 * t273)).sub_product(t94, t274).sub_product(t98, t270).sub_product(t100, t269)
        .sub_product(t102, t267);
    let t276 = (t83 * t274).sub_product(t81, t275).sub_product(t85, t273).sub_product(t87, t270)
        .sub_product(t89, t269).sub_product(t91, t267);
    let t277 = (-(t70 * t275)).sub_product(t68, t276).sub_product(t73, t270).sub_product(t76, t269)
        .sub_product(t78, t267);
    let t278 = (-(t56 * t276)).sub_product(t54, t277).sub_product(t57, t275).sub_product(t60, t270)
        .add_product(t62, t269).sub_product(t64, t267);
    let t279 = (-(t47 * t277)).sub_product(t45, t278).sub_product(t49, t267);
    let t280 = (-(t37 * t278)).sub_product(t35, t279).sub_product(t35, t277).add_product(t39, t267);
    let drum_v_y_dot_by_bobbin_mass = (t30 * t268).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_y_minus_drum_y_over_between * t268);
    let drum_v_x_dot_by_bobbin_mass = (t29 * t268).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t268);
    let bobbin_v_y_dot_by_bobbin_mass = t264.sub_product(inverse_bobbin_mass, t269)
        .sub_product(t28, t268);
    let bobbin_v_x_dot_by_bobbin_mass = t263.sub_product(inverse_bobbin_mass, t270)
        .sub_product(t27, t268);
    let rod_omega_dot_by_bobbin_mass = (t25 * t272).sub_product(R::literal(4_166.666_666_666_667),
        t274).sub_product(t26, t271);
    let rod_v_y_dot_by_bobbin_mass = (-(R::literal(5.0) * t271)).sub_product(t24, t273);
    let rod_v_x_dot_by_bobbin_mass = (-(R::literal(5.0) * t272)).add_product(t23, t273);
    let cylinder_omega_dot_by_bobbin_mass = (t21 * t275).sub_product(t20, t276)
        .sub_product(R::literal(-2_777.777_777_777_778), t274).add_product(t22, t273);
    let cylinder_v_y_dot_by_bobbin_mass = (t19 * t273)
        .sub_product(R::literal(3.333_333_333_333_333_5), t275);
    let cylinder_v_x_dot_by_bobbin_mass = (-(t18 * t273))
        .sub_product(R::literal(3.333_333_333_333_333_5), t276);
    let plate_omega_dot_by_bobbin_mass = (t15 * t277).sub_product(t14, t278).sub_product(t14, t276)
        .add_product(t15, t275).add_product(t16, t270).sub_product(t17, t269);
    let plate_v_y_dot_by_bobbin_mass = (-(R::literal(-0.833_333_333_333_333_4) * t275))
        .sub_product(R::literal(0.833_333_333_333_333_4), t277)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t269);
    let plate_v_x_dot_by_bobbin_mass = (-(R::literal(-0.833_333_333_333_333_4) * t276))
        .sub_product(R::literal(0.833_333_333_333_333_4), t278)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t270);
    let post_omega_dot_by_bobbin_mass = (t12 * t279).sub_product(t11, t280).sub_product(t11, t278)
        .add_product(t12, t277).sub_product(t13, t267);
    let post_v_y_dot_by_bobbin_mass = (-(R::literal(-1.25) * t277)).sub_product(R::literal(1.25),
        t279);
    let post_v_x_dot_by_bobbin_mass = (-(R::literal(-1.25) * t278)).sub_product(R::literal(1.25),
        t280);
    let t281 = slide_minus_spring_free_length * cos_cylinder_phi;
    let t282 = slide_minus_spring_free_length * sin_cylinder_phi;
    let t283 = slide_minus_spring_free_length * t7;
    let t284 = R::literal(3.333_333_333_333_333_5) * t281;
    let t285 = (-t284).add_product(t20, t283);
    let t286 = R::literal(3.333_333_333_333_333_5) * t282;
    let t287 = (-t286).sub_product(t21, t283).sub_product(t81, t285);
    let t288 = (R::literal(-2_777.777_777_777_778) * t283).add_product(t83, t285).sub_product(t94,
        t287);
    let t289 = (t19 * t282).sub_product(t18, t281).sub_product(t22, t283).sub_product(t23, t281)
        .add_product(t24, t282).sub_product(t85, t285).sub_product(t96, t287).sub_product(t105,
        t288);
    let t290 = R::literal(5.0) * t281;
    let t291 = t290.sub_product(t106, t288).sub_product(t116, t289);
    let t292 = R::literal(5.0) * t282;
    let t293 = t292.add_product(t107, t288).sub_product(t118, t289).sub_product(t127, t291);
    let t294 = (-(t87 * t285)).sub_product(t98, t287).sub_product(t109, t288).sub_product(t120,
        t289).sub_product(t129, t291).sub_product(t136, t293);
    let t295 = (-(t89 * t285)).sub_product(t100, t287).sub_product(t111, t288).sub_product(t122,
        t289).sub_product(t131, t291).sub_product(t138, t293).sub_product(t143, t294);
    let t296 = (t144 * t294).sub_product(t149, t295);
    let t297 = (-(t91 * t285)).sub_product(t102, t287).sub_product(t113, t288).sub_product(t124,
        t289).sub_product(t133, t291).sub_product(t140, t293).sub_product(t146, t294)
        .sub_product(t151, t295).sub_product(t156, t296) * t157;
    let t298 = (t296 * t154).sub_product(t156, t297);
    let t299 = (t295 * t147).sub_product(t149, t298).sub_product(t151, t297);
    let t300 = (t294 * t141).sub_product(t143, t299).add_product(t144, t298).sub_product(t146,
        t297);
    let t301 = (t293 * t134).sub_product(t136, t300).sub_product(t138, t299).sub_product(t140,
        t297);
    let t302 = (t291 * t125).sub_product(t127, t301).sub_product(t129, t300).sub_product(t131, t299)
        .sub_product(t133, t297);
    let t303 = (t289 * t114).sub_product(t116, t302).sub_product(t118, t301).sub_product(t120, t300)
        .sub_product(t122, t299).sub_product(t124, t297);
    let t304 = (t288 * t103).sub_product(t105, t303).sub_product(t106, t302).add_product(t107, t301)
        .sub_product(t109, t300).sub_product(t111, t299).sub_product(t113, t297);
    let t305 = (t287 * t92).sub_product(t94, t304).sub_product(t96, t303).sub_product(t98, t300)
        .sub_product(t100, t299).sub_product(t102, t297);
    let t306 = (t285 * t79).sub_product(t81, t305).add_product(t83, t304).sub_product(t85, t303)
        .sub_product(t87, t300).sub_product(t89, t299).sub_product(t91, t297);
    let t307 = (-(t70 * t305)).sub_product(t68, t306).sub_product(t73, t300).sub_product(t76, t299)
        .sub_product(t78, t297);
    let t308 = (-(t56 * t306)).sub_product(t54, t307).sub_product(t57, t305).sub_product(t60, t300)
        .add_product(t62, t299).sub_product(t64, t297);
    let t309 = (-(t47 * t307)).sub_product(t45, t308).sub_product(t49, t297);
    let t310 = (-(t37 * t308)).sub_product(t35, t309).sub_product(t35, t307).add_product(t39, t297);
    let drum_v_y_dot_by_spring_stiffness = (t30 * t298)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t298);
    let drum_v_x_dot_by_spring_stiffness = (t29 * t298)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t298);
    let bobbin_v_y_dot_by_spring_stiffness = (-(t28 * t298)).sub_product(inverse_bobbin_mass, t299);
    let bobbin_v_x_dot_by_spring_stiffness = (-(t27 * t298)).sub_product(inverse_bobbin_mass, t300);
    let rod_omega_dot_by_spring_stiffness = (t25 * t302)
        .sub_product(R::literal(4_166.666_666_666_667), t304).sub_product(t26, t301);
    let rod_v_y_dot_by_spring_stiffness = (-t292).sub_product(t24, t303)
        .sub_product(R::literal(5.0), t301);
    let rod_v_x_dot_by_spring_stiffness = (-t290).add_product(t23, t303)
        .sub_product(R::literal(5.0), t302);
    let cylinder_omega_dot_by_spring_stiffness = (-(t283 * R::literal(2_777.777_777_777_778)))
        .sub_product(t20, t306).add_product(t21, t305)
        .sub_product(R::literal(-2_777.777_777_777_778), t304).add_product(t22, t303);
    let cylinder_v_y_dot_by_spring_stiffness = t286
        .sub_product(R::literal(3.333_333_333_333_333_5), t305).add_product(t19, t303);
    let cylinder_v_x_dot_by_spring_stiffness = t284
        .sub_product(R::literal(3.333_333_333_333_333_5), t306).sub_product(t18, t303);
    let plate_omega_dot_by_spring_stiffness = (t15 * t307).sub_product(t14, t308).sub_product(t14,
        t306).add_product(t15, t305).add_product(t16, t300).sub_product(t17, t299);
    let plate_v_y_dot_by_spring_stiffness = (-(R::literal(-0.833_333_333_333_333_4) * t305))
        .sub_product(R::literal(0.833_333_333_333_333_4), t307)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t299);
    let plate_v_x_dot_by_spring_stiffness = (-(R::literal(-0.833_333_333_333_333_4) * t306))
        .sub_product(R::literal(0.833_333_333_333_333_4), t308)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t300);
    let post_omega_dot_by_spring_stiffness = (t12 * t309).sub_product(t11, t310).sub_product(t11,
        t308).add_product(t12, t307).sub_product(t13, t297);
    let post_v_y_dot_by_spring_stiffness = (-(R::literal(-1.25) * t307))
        .sub_product(R::literal(1.25), t309);
    let post_v_x_dot_by_spring_stiffness = (-(R::literal(-1.25) * t308))
        .sub_product(R::literal(1.25), t310);
    let t311 = R::literal(3.333_333_333_333_333_5) * t206;
    let t312 = t311.sub_product(t20, t207);
    let t313 = R::literal(3.333_333_333_333_333_5) * t208;
    let t314 = t313.add_product(t21, t207).sub_product(t81, t312);
    let t315 = (-(R::literal(-2_777.777_777_777_778) * t207)).add_product(t83, t312)
        .sub_product(t94, t314);
    let t316 = (t18 * t206).sub_product(t19, t208).add_product(t22, t207).add_product(t23, t206)
        .sub_product(t24, t208).sub_product(t85, t312).sub_product(t96, t314).sub_product(t105,
        t315);
    let t317 = R::literal(5.0) * t206;
    let t318 = (-t317).sub_product(t106, t315).sub_product(t116, t316);
    let t319 = R::literal(5.0) * t208;
    let t320 = (-t319).add_product(t107, t315).sub_product(t118, t316).sub_product(t127, t318);
    let t321 = (-(t87 * t312)).sub_product(t98, t314).sub_product(t109, t315).sub_product(t120,
        t316).sub_product(t129, t318).sub_product(t136, t320);
    let t322 = (-(t89 * t312)).sub_product(t100, t314).sub_product(t111, t315).sub_product(t122,
        t316).sub_product(t131, t318).sub_product(t138, t320).sub_product(t143, t321);
    let t323 = (t144 * t321).sub_product(t149, t322);
    let t324 = (-(t91 * t312)).sub_product(t102, t314).sub_product(t113, t315).sub_product(t124,
        t316).sub_product(t133, t318).sub_product(t140, t320).sub_product(t146, t321)
        .sub_product(t151, t322).sub_product(t156, t323) * t157;
    let t325 = (t323 * t154).sub_product(t156, t324);
    let t326 = (t322 * t147).sub_product(t149, t325).sub_product(t151, t324);
    let t327 = (t321 * t141).sub_product(t143, t326).add_product(t144, t325).sub_product(t146,
        t324);
    let t328 = (t320 * t134).sub_product(t136, t327).sub_product(t138, t326).sub_product(t140,
        t324);
    let t329 = (t318 * t125).sub_product(t127, t328).sub_product(t129, t327).sub_product(t131, t326)
        .sub_product(t133, t324);
    let t330 = (t316 * t114).sub_product(t116, t329).sub_product(t118, t328).sub_product(t120, t327)
        .sub_product(t122, t326).sub_product(t124, t324);
    let t331 = (t315 * t103).sub_product(t105, t330).sub_product(t106, t329).add_product(t107, t328)
        .sub_product(t109, t327).sub_product(t111, t326).sub_product(t113, t324);
    let t332 = (t314 * t92).sub_product(t94, t331).sub_product(t96, t330).sub_product(t98, t327)
        .sub_product(t100, t326).sub_product(t102, t324);
    let t333 = (t312 * t79).sub_product(t81, t332).add_product(t83, t331).sub_product(t85, t330)
        .sub_product(t87, t327).sub_product(t89, t326).sub_product(t91, t324);
    let t334 = (-(t70 * t332)).sub_product(t68, t333).sub_product(t73, t327).sub_product(t76, t326)
        .sub_product(t78, t324);
    let t335 = (-(t56 * t333)).sub_product(t54, t334).sub_product(t57, t332).sub_product(t60, t327)
        .add_product(t62, t326).sub_product(t64, t324);
    let t336 = (-(t47 * t334)).sub_product(t45, t335).sub_product(t49, t324);
    let t337 = (-(t37 * t335)).sub_product(t35, t336).sub_product(t35, t334).add_product(t39, t324);
    let drum_v_y_dot_by_spring_free_length = (t30 * t325)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_y_minus_drum_y_over_between
        * t325);
    let drum_v_x_dot_by_spring_free_length = (t29 * t325)
        .sub_product(R::literal(0.666_666_666_666_666_6), bobbin_x_minus_drum_x_over_between
        * t325);
    let bobbin_v_y_dot_by_spring_free_length = (-(t28 * t325)).sub_product(inverse_bobbin_mass,
        t326);
    let bobbin_v_x_dot_by_spring_free_length = (-(t27 * t325)).sub_product(inverse_bobbin_mass,
        t327);
    let rod_omega_dot_by_spring_free_length = (t25 * t329)
        .sub_product(R::literal(4_166.666_666_666_667), t331).sub_product(t26, t328);
    let rod_v_y_dot_by_spring_free_length = t319.sub_product(t24, t330)
        .sub_product(R::literal(5.0), t328);
    let rod_v_x_dot_by_spring_free_length = t317.add_product(t23, t330)
        .sub_product(R::literal(5.0), t329);
    let cylinder_omega_dot_by_spring_free_length = (t207 * R::literal(2_777.777_777_777_778))
        .sub_product(t20, t333).add_product(t21, t332)
        .sub_product(R::literal(-2_777.777_777_777_778), t331).add_product(t22, t330);
    let cylinder_v_y_dot_by_spring_free_length = (-t313)
        .sub_product(R::literal(3.333_333_333_333_333_5), t332).add_product(t19, t330);
    let cylinder_v_x_dot_by_spring_free_length = (-t311)
        .sub_product(R::literal(3.333_333_333_333_333_5), t333).sub_product(t18, t330);
    let plate_omega_dot_by_spring_free_length = (t15 * t334).sub_product(t14, t335)
        .sub_product(t14, t333).add_product(t15, t332).add_product(t16, t327).sub_product(t17,
        t326);
    let plate_v_y_dot_by_spring_free_length = (-(R::literal(-0.833_333_333_333_333_4) * t332))
        .sub_product(R::literal(0.833_333_333_333_333_4), t334)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t326);
    let plate_v_x_dot_by_spring_free_length = (-(R::literal(-0.833_333_333_333_333_4) * t333))
        .sub_product(R::literal(0.833_333_333_333_333_4), t335)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t327);
    let post_omega_dot_by_spring_free_length = (t12 * t336).sub_product(t11, t337).sub_product(t11,
        t335).add_product(t12, t334).sub_product(t13, t324);
    let post_v_y_dot_by_spring_free_length = (-(R::literal(-1.25) * t334))
        .sub_product(R::literal(1.25), t336);
    let post_v_x_dot_by_spring_free_length = (-(R::literal(-1.25) * t335))
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

/// Wanted outputs. 800 operations.
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
    let t30 = R::literal(-1.25) - t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t12 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t13 * t1;
    let t37 = t36 * t31;
    let t38 = t12 * t0;
    let t39 = R::literal(-1.25) - t38;
    let t40 = t33 * t32;
    let t41 = R::literal(1.0) / (t39 - t40);
    let t42 = (t11 * t0).sub_product(t35, t32);
    let t43 = t42 * t41;
    let t44 = R::literal(1.25) - t38 - t40;
    let t45 = t44 * t41;
    let t46 = (t13 * t0).add_product(t37, t32);
    let t47 = t46 * t41;
    let t48 = t14 * t3;
    let t49 = R::literal(1.0) / (t30 - R::literal(0.833_333_333_333_333_4) - t48).sub_product(t35,
        t34).sub_product(t43, t42);
    let t50 = t15 * t3;
    let t51 = (t32 + t50).sub_product(t33, t34).sub_product(t45, t42);
    let t52 = t51 * t49;
    let t53 = R::literal(0.833_333_333_333_333_4) - t48;
    let t54 = t53 * t49;
    let t55 = t50 * t49;
    let t56 = t16 * t3;
    let t57 = R::literal(0.833_333_333_333_333_4) + t56;
    let t58 = t57 * t49;
    let t59 = t17 * t3;
    let t60 = t59 * t49;
    let t61 = (-t36).add_product(t37, t34).sub_product(t47, t42);
    let t62 = t61 * t49;
    let t63 = t15 * t2;
    let t64 = R::literal(1.0) / (t39 - R::literal(0.833_333_333_333_333_4) - t63 - t40)
        .sub_product(t45, t44).sub_product(t52, t51);
    let t65 = (t14 * t2).sub_product(t54, t51);
    let t66 = t65 * t64;
    let t67 = (R::literal(0.833_333_333_333_333_4) - t63).sub_product(t55, t51);
    let t68 = t67 * t64;
    let t69 = -(t16 * t2);
    let t70 = t69.sub_product(t58, t51);
    let t71 = t70 * t64;
    let t72 = t17 * t2;
    let t73 = (R::literal(0.833_333_333_333_333_4) + t72).add_product(t60, t51);
    let t74 = t73 * t64;
    let t75 = t46.sub_product(t47, t44).sub_product(t62, t51);
    let t76 = t75 * t64;
    let t77 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t48
        - R::literal(3.333_333_333_333_333_5)).sub_product(t20, t5).sub_product(t54, t53)
        .sub_product(t66, t65);
    let t78 = t50.add_product(t21, t5).sub_product(t55, t53).sub_product(t68, t65);
    let t79 = t78 * t77;
    let t80 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t81 = t80 * t77;
    let t82 = (-t18).add_product(t22, t5);
    let t83 = t82 * t77;
    let t84 = (R::literal(-0.833_333_333_333_333_4) + t56).sub_product(t58, t53).sub_product(t71,
        t65);
    let t85 = t84 * t77;
    let t86 = (-t59).add_product(t60, t53).sub_product(t74, t65);
    let t87 = t86 * t77;
    let t88 = (-(t62 * t53)).sub_product(t76, t65);
    let t89 = t88 * t77;
    let t90 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t63
        - R::literal(3.333_333_333_333_333_5)).sub_product(t21, t4).sub_product(t55, t50)
        .sub_product(t68, t67).sub_product(t79, t78);
    let t91 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).add_product(t81, t78);
    let t92 = t91 * t90;
    let t93 = t19.sub_product(t22, t4).sub_product(t83, t78);
    let t94 = t93 * t90;
    let t95 = t69.sub_product(t58, t50).sub_product(t71, t67).sub_product(t85, t78);
    let t96 = t95 * t90;
    let t97 = (R::literal(-0.833_333_333_333_333_4) + t72).add_product(t60, t50).sub_product(t74,
        t67).sub_product(t87, t78);
    let t98 = t97 * t90;
    let t99 = (-(t62 * t50)).sub_product(t76, t67).sub_product(t89, t78);
    let t100 = t99 * t90;
    let t101 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).sub_product(t81, t80)
        .sub_product(t92, t91);
    let t102 = (-t22).add_product(t83, t80).sub_product(t94, t91);
    let t103 = t102 * t101;
    let t104 = t25 * t101;
    let t105 = t26 * t101;
    let t106 = (t85 * t80).sub_product(t96, t91);
    let t107 = t106 * t101;
    let t108 = (t87 * t80).sub_product(t98, t91);
    let t109 = t108 * t101;
    let t110 = (t89 * t80).sub_product(t100, t91);
    let t111 = t110 * t101;
    let t112 = R::literal(1.0) / (-(t19 * cos_cylinder_phi)).sub_product(t18, sin_cylinder_phi)
        .sub_product(t22, slide).sub_product(t23, sin_cylinder_phi).sub_product(t24,
        cos_cylinder_phi).sub_product(t83, t82).sub_product(t94, t93).sub_product(t103, t102);
    let t113 = t23.sub_product(t104, t102);
    let t114 = t113 * t112;
    let t115 = (-t24).add_product(t105, t102);
    let t116 = t115 * t112;
    let t117 = (-(t85 * t82)).sub_product(t96, t93).sub_product(t107, t102);
    let t118 = t117 * t112;
    let t119 = (-(t87 * t82)).sub_product(t98, t93).sub_product(t109, t102);
    let t120 = t119 * t112;
    let t121 = (-(t89 * t82)).sub_product(t100, t93).sub_product(t111, t102);
    let t122 = t121 * t112;
    let t123 = R::literal(1.0) / R::literal(-5.0).sub_product(t25, t6).sub_product(t104, t25)
        .sub_product(t114, t113);
    let t124 = (t26 * t6).add_product(t105, t25).sub_product(t116, t113);
    let t125 = t124 * t123;
    let t126 = (-(t107 * t25)).sub_product(t118, t113);
    let t127 = t126 * t123;
    let t128 = (-(t109 * t25)).sub_product(t120, t113);
    let t129 = t128 * t123;
    let t130 = (-(t111 * t25)).sub_product(t122, t113);
    let t131 = t130 * t123;
    let t132 = R::literal(1.0) / R::literal(-5.0).sub_product(t26, R::literal(0.06) * cos_rod_phi)
        .sub_product(t105, t26).sub_product(t116, t115).sub_product(t125, t124);
    let t133 = (t107 * t26).sub_product(t118, t115).sub_product(t127, t124);
    let t134 = t133 * t132;
    let t135 = (t109 * t26).sub_product(t120, t115).sub_product(t129, t124);
    let t136 = t135 * t132;
    let t137 = (t111 * t26).sub_product(t122, t115).sub_product(t131, t124);
    let t138 = t137 * t132;
    let t139 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t16, t9)
        - inverse_bobbin_mass).sub_product(t58, t57).sub_product(t71, t70).sub_product(t85, t84)
        .sub_product(t96, t95).sub_product(t107, t106).sub_product(t118, t117).sub_product(t127,
        t126).sub_product(t134, t133);
    let t140 = (t17 * t9).add_product(t60, t57).sub_product(t74, t70).sub_product(t87, t84)
        .sub_product(t98, t95).sub_product(t109, t106).sub_product(t120, t117).sub_product(t129,
        t126).sub_product(t136, t133);
    let t141 = t140 * t139;
    let t142 = t27 * t139;
    let t143 = (-(t62 * t57)).sub_product(t76, t70).sub_product(t89, t84).sub_product(t100, t95)
        .sub_product(t111, t106).sub_product(t122, t117).sub_product(t131, t126).sub_product(t138,
        t133);
    let t144 = t143 * t139;
    let t145 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
        - inverse_bobbin_mass).sub_product(t60, t59).sub_product(t74, t73).sub_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).sub_product(t129,
        t128).sub_product(t136, t135).sub_product(t141, t140);
    let t146 = (-t28).add_product(t142, t140);
    let t147 = t146 * t145;
    let t148 = (t62 * t59).sub_product(t76, t73).sub_product(t89, t86).sub_product(t100, t97)
        .sub_product(t111, t108).sub_product(t122, t119).sub_product(t131, t128).sub_product(t138,
        t135).sub_product(t144, t140);
    let t149 = t148 * t145;
    let t150 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6)
        * bobbin_x_minus_drum_x_over_between;
    let t151 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6)
        * bobbin_y_minus_drum_y_over_between;
    let t152 = R::literal(1.0) / (((-(t28 * bobbin_y_minus_drum_y_over_between)).sub_product(t27,
        bobbin_x_minus_drum_x_over_between) - t150 - t151).sub_product(t142, t27).sub_product(t147,
        t146) + t150 + t151);
    let t153 = (t144 * t27).sub_product(t149, t146);
    let t154 = t153 * t152;
    let t155 = R::literal(1.0) / (-(t13 * t8)).sub_product(t37, t36).sub_product(t47, t46)
        .sub_product(t62, t61).sub_product(t76, t75).sub_product(t89, t88).sub_product(t100, t99)
        .sub_product(t111, t110).sub_product(t122, t121).sub_product(t131, t130).sub_product(t138,
        t137).sub_product(t144, t143).sub_product(t149, t148).sub_product(t154, t153);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t156 = R::literal(50.0) * slide_rate;
    let t157 = t156 * cos_cylinder_phi;
    let t158 = p.spring_stiffness * (slide - p.spring_free_length);
    let t159 = t158 * cos_cylinder_phi;
    let t160 = t157 + t159;
    let t161 = t158 * sin_cylinder_phi;
    let t162 = t156 * sin_cylinder_phi;
    let t163 = t162 - (R::literal(2.943) - t161);
    let t164 = (-(t158 * t7)).sub_product(t156, t7);
    let t165 = -t157 - t159;
    let t166 = -t162 - (R::literal(1.962) + t161);
    let t167 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t168 = (p.winding_force * bobbin_x_minus_drum_x / between).sub_product(R::literal(9.81),
        p.bobbin_mass);
    let post_omega_squared = post_omega * post_omega;
    let t169 = R::literal(0.1) * post_omega_squared;
    let t170 = t169 * cos_post_phi;
    let t171 = t169 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t172 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t173 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t174 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t175 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t176 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t177 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t178 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t179 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t180 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t181 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t182 = (bobbin_v_x * (bobbin_v_x_over_between + t176 + t177 - t174 - t175
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t180 + t181
        - t178 - t179 - drum_v_y_over_between).add_product(drum_v_x, t174 + t175
        + drum_v_x_over_between - bobbin_v_x_over_between - t176 - t177).add_product(drum_v_y, t178
        + t179 + drum_v_y_over_between - bobbin_v_y_over_between - t180 - t181);
    let t183 = t33 * t170;
    let t184 = -t171 - R::literal(-9.81) + t183;
    let t185 = t14 * bobbin_radius_times_winding_force;
    let t186 = (t185 - t170.add_product(t172, cos_plate_phi)).add_product(t35, t170)
        .sub_product(t43, t184);
    let t187 = t15 * bobbin_radius_times_winding_force;
    let t188 = (-t171.add_product(t172, sin_plate_phi) - R::literal(9.81) - R::literal(-9.81)
        - t187 + t183).sub_product(t45, t184).sub_product(t52, t186);
    let t189 = t185.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi))
        .sub_product(R::literal(3.333_333_333_333_333_5), t160).sub_product(t20, t164)
        .sub_product(t54, t186).sub_product(t66, t188);
    let t190 = (R::literal(-9.81).sub_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) - t187)
        .sub_product(R::literal(3.333_333_333_333_333_5), t163).add_product(t21, t164)
        .sub_product(t55, t186).sub_product(t68, t188).sub_product(t79, t189);
    let t191 = (-(R::literal(-2_777.777_777_777_778) * t164)).add_product(t81, t189)
        .sub_product(t92, t190);
    let t192 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t160)
        .add_product(t19, t163).add_product(t22, t164).add_product(t23, t165).sub_product(t24, t166)
        .sub_product(t83, t189).sub_product(t94, t190);
    let t193 = t192.sub_product(t103, t191);
    let t194 = (t173 * cos_rod_phi).sub_product(R::literal(5.0), t165).sub_product(t104, t191)
        .sub_product(t114, t193);
    let t195 = (t173 * sin_rod_phi).sub_product(R::literal(5.0), t166).add_product(t105, t191)
        .sub_product(t116, t193).sub_product(t125, t194);
    let t196 = (t10 * plate_omega_squared).sub_product(t16, bobbin_radius_times_winding_force)
        .add_product(inverse_bobbin_mass, t167).sub_product(t58, t186).sub_product(t71, t188)
        .sub_product(t85, t189).sub_product(t96, t190).sub_product(t107, t191).sub_product(t118,
        t193).sub_product(t127, t194).sub_product(t134, t195);
    let t197 = R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        bobbin_radius_times_winding_force).sub_product(inverse_bobbin_mass, t168).add_product(t60,
        t186).sub_product(t74, t188).sub_product(t87, t189).sub_product(t98, t190)
        .sub_product(t109, t191).sub_product(t120, t193).sub_product(t129, t194).sub_product(t136,
        t195).sub_product(t141, t196);
    let t198 = (-t182).add_product(t27, t167).sub_product(t28, t168)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t142, t196).sub_product(t147, t197)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t199 = ((R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi)
        * post_omega_squared).sub_product(t37, t170).sub_product(t47, t184).sub_product(t62, t186)
        .sub_product(t76, t188).sub_product(t89, t189).sub_product(t100, t190).sub_product(t111,
        t191).sub_product(t122, t193).sub_product(t131, t194).sub_product(t138, t195)
        .sub_product(t144, t196).sub_product(t149, t197).sub_product(t154, t198) * t155;
    let contact = (-(t198 * t152)).add_product(t154, t199);
    let stop = -t199;
    Outputs {
        contact_force: contact,
        stop_force: stop,
        strut_push: -t156 - t158,
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 1099 operations.
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
    let t32 = R::literal(-1.25) - t31;
    let t33 = R::literal(1.0) / t32;
    let t34 = t12 * t1;
    let t35 = t34 * t33;
    let t36 = R::literal(1.25) - t31;
    let t37 = t36 * t33;
    let t38 = t13 * t1;
    let t39 = t38 * t33;
    let t40 = t12 * t0;
    let t41 = R::literal(-1.25) - t40;
    let t42 = t35 * t34;
    let t43 = R::literal(1.0) / (t41 - t42);
    let t44 = (t11 * t0).sub_product(t37, t34);
    let t45 = t44 * t43;
    let t46 = R::literal(1.25) - t40 - t42;
    let t47 = t46 * t43;
    let t48 = (t13 * t0).add_product(t39, t34);
    let t49 = t48 * t43;
    let t50 = t14 * t3;
    let t51 = R::literal(1.0) / (t32 - R::literal(0.833_333_333_333_333_4) - t50).sub_product(t37,
        t36).sub_product(t45, t44);
    let t52 = t15 * t3;
    let t53 = (t34 + t52).sub_product(t35, t36).sub_product(t47, t44);
    let t54 = t53 * t51;
    let t55 = R::literal(0.833_333_333_333_333_4) - t50;
    let t56 = t55 * t51;
    let t57 = t52 * t51;
    let t58 = t16 * t3;
    let t59 = R::literal(0.833_333_333_333_333_4) + t58;
    let t60 = t59 * t51;
    let t61 = t17 * t3;
    let t62 = t61 * t51;
    let t63 = (-t38).add_product(t39, t36).sub_product(t49, t44);
    let t64 = t63 * t51;
    let t65 = t15 * t2;
    let t66 = R::literal(1.0) / (t41 - R::literal(0.833_333_333_333_333_4) - t65 - t42)
        .sub_product(t47, t46).sub_product(t54, t53);
    let t67 = (t14 * t2).sub_product(t56, t53);
    let t68 = t67 * t66;
    let t69 = (R::literal(0.833_333_333_333_333_4) - t65).sub_product(t57, t53);
    let t70 = t69 * t66;
    let t71 = -(t16 * t2);
    let t72 = t71.sub_product(t60, t53);
    let t73 = t72 * t66;
    let t74 = t17 * t2;
    let t75 = (R::literal(0.833_333_333_333_333_4) + t74).add_product(t62, t53);
    let t76 = t75 * t66;
    let t77 = t48.sub_product(t49, t46).sub_product(t64, t53);
    let t78 = t77 * t66;
    let t79 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t50
        - R::literal(3.333_333_333_333_333_5)).sub_product(t20, t5).sub_product(t56, t55)
        .sub_product(t68, t67);
    let t80 = t52.add_product(t21, t5).sub_product(t57, t55).sub_product(t70, t67);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = (-t18).add_product(t22, t5);
    let t85 = t84 * t79;
    let t86 = (R::literal(-0.833_333_333_333_333_4) + t58).sub_product(t60, t55).sub_product(t73,
        t67);
    let t87 = t86 * t79;
    let t88 = (-t61).add_product(t62, t55).sub_product(t76, t67);
    let t89 = t88 * t79;
    let t90 = (-(t64 * t55)).sub_product(t78, t67);
    let t91 = t90 * t79;
    let t92 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4) - t65
        - R::literal(3.333_333_333_333_333_5)).sub_product(t21, t4).sub_product(t57, t52)
        .sub_product(t70, t69).sub_product(t81, t80);
    let t93 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi).add_product(t83, t80);
    let t94 = t93 * t92;
    let t95 = t19.sub_product(t22, t4).sub_product(t85, t80);
    let t96 = t95 * t92;
    let t97 = t71.sub_product(t60, t52).sub_product(t73, t69).sub_product(t87, t80);
    let t98 = t97 * t92;
    let t99 = (R::literal(-0.833_333_333_333_333_4) + t74).add_product(t62, t52).sub_product(t76,
        t69).sub_product(t89, t80);
    let t100 = t99 * t92;
    let t101 = (-(t64 * t52)).sub_product(t78, t69).sub_product(t91, t80);
    let t102 = t101 * t92;
    let t103 = R::literal(1.0) / R::literal(-6_944.444_444_444_445).sub_product(t83, t82)
        .sub_product(t94, t93);
    let t104 = (-t22).add_product(t85, t82).sub_product(t96, t93);
    let t105 = t104 * t103;
    let t106 = t25 * t103;
    let t107 = t26 * t103;
    let t108 = (t87 * t82).sub_product(t98, t93);
    let t109 = t108 * t103;
    let t110 = (t89 * t82).sub_product(t100, t93);
    let t111 = t110 * t103;
    let t112 = (t91 * t82).sub_product(t102, t93);
    let t113 = t112 * t103;
    let t114 = R::literal(1.0) / (-(t19 * cos_cylinder_phi)).sub_product(t18, sin_cylinder_phi)
        .sub_product(t22, slide).sub_product(t23, sin_cylinder_phi).sub_product(t24,
        cos_cylinder_phi).sub_product(t85, t84).sub_product(t96, t95).sub_product(t105, t104);
    let t115 = t23.sub_product(t106, t104);
    let t116 = t115 * t114;
    let t117 = (-t24).add_product(t107, t104);
    let t118 = t117 * t114;
    let t119 = (-(t87 * t84)).sub_product(t98, t95).sub_product(t109, t104);
    let t120 = t119 * t114;
    let t121 = (-(t89 * t84)).sub_product(t100, t95).sub_product(t111, t104);
    let t122 = t121 * t114;
    let t123 = (-(t91 * t84)).sub_product(t102, t95).sub_product(t113, t104);
    let t124 = t123 * t114;
    let t125 = R::literal(1.0) / R::literal(-5.0).sub_product(t25, t6).sub_product(t106, t25)
        .sub_product(t116, t115);
    let t126 = (t26 * t6).add_product(t107, t25).sub_product(t118, t115);
    let t127 = t126 * t125;
    let t128 = (-(t109 * t25)).sub_product(t120, t115);
    let t129 = t128 * t125;
    let t130 = (-(t111 * t25)).sub_product(t122, t115);
    let t131 = t130 * t125;
    let t132 = (-(t113 * t25)).sub_product(t124, t115);
    let t133 = t132 * t125;
    let t134 = R::literal(1.0) / R::literal(-5.0).sub_product(t26, R::literal(0.06) * cos_rod_phi)
        .sub_product(t107, t26).sub_product(t118, t117).sub_product(t127, t126);
    let t135 = (t109 * t26).sub_product(t120, t117).sub_product(t129, t126);
    let t136 = t135 * t134;
    let t137 = (t111 * t26).sub_product(t122, t117).sub_product(t131, t126);
    let t138 = t137 * t134;
    let t139 = (t113 * t26).sub_product(t124, t117).sub_product(t133, t126);
    let t140 = t139 * t134;
    let t141 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t16, t9)
        - inverse_bobbin_mass).sub_product(t60, t59).sub_product(t73, t72).sub_product(t87, t86)
        .sub_product(t98, t97).sub_product(t109, t108).sub_product(t120, t119).sub_product(t129,
        t128).sub_product(t136, t135);
    let t142 = (t17 * t9).add_product(t62, t59).sub_product(t76, t72).sub_product(t89, t86)
        .sub_product(t100, t97).sub_product(t111, t108).sub_product(t122, t119).sub_product(t131,
        t128).sub_product(t138, t135);
    let t143 = t142 * t141;
    let t144 = t27 * t141;
    let t145 = (-(t64 * t59)).sub_product(t78, t72).sub_product(t91, t86).sub_product(t102, t97)
        .sub_product(t113, t108).sub_product(t124, t119).sub_product(t133, t128).sub_product(t140,
        t135);
    let t146 = t145 * t141;
    let t147 = R::literal(1.0) / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
        - inverse_bobbin_mass).sub_product(t62, t61).sub_product(t76, t75).sub_product(t89, t88)
        .sub_product(t100, t99).sub_product(t111, t110).sub_product(t122, t121).sub_product(t131,
        t130).sub_product(t138, t137).sub_product(t143, t142);
    let t148 = (-t28).add_product(t144, t142);
    let t149 = t148 * t147;
    let t150 = (t64 * t61).sub_product(t78, t75).sub_product(t91, t88).sub_product(t102, t99)
        .sub_product(t113, t110).sub_product(t124, t121).sub_product(t133, t130).sub_product(t140,
        t137).sub_product(t146, t142);
    let t151 = t150 * t147;
    let t152 = t29 * bobbin_x_minus_drum_x_over_between;
    let t153 = t30 * bobbin_y_minus_drum_y_over_between;
    let t154 = R::literal(1.0) / (((-(t28 * bobbin_y_minus_drum_y_over_between)).sub_product(t27,
        bobbin_x_minus_drum_x_over_between) - t152 - t153).sub_product(t144, t27).sub_product(t149,
        t148) + t152 + t153);
    let t155 = (t146 * t27).sub_product(t151, t148);
    let t156 = t155 * t154;
    let t157 = R::literal(1.0) / (-(t13 * t8)).sub_product(t39, t38).sub_product(t49, t48)
        .sub_product(t64, t63).sub_product(t78, t77).sub_product(t91, t90).sub_product(t102, t101)
        .sub_product(t113, t112).sub_product(t124, t123).sub_product(t133, t132).sub_product(t140,
        t139).sub_product(t146, t145).sub_product(t151, t150).sub_product(t156, t155);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t158 = R::literal(50.0) * slide_rate;
    let t159 = t158 * cos_cylinder_phi;
    let t160 = p.spring_stiffness * (slide - p.spring_free_length);
    let t161 = t160 * cos_cylinder_phi;
    let t162 = t159 + t161;
    let t163 = t160 * sin_cylinder_phi;
    let t164 = R::literal(2.943) - t163;
    let t165 = t158 * sin_cylinder_phi;
    let t166 = t165 - t164;
    let t167 = t160 * t7;
    let t168 = (-t167).sub_product(t158, t7);
    let t169 = -t159 - t161;
    let t170 = R::literal(1.962) + t163;
    let t171 = -t165 - t170;
    let t172 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t173 = R::literal(9.81) * p.bobbin_mass;
    let t174 = p.winding_force * bobbin_x_minus_drum_x / between - t173;
    let post_omega_squared = post_omega * post_omega;
    let t175 = R::literal(0.1) * post_omega_squared;
    let t176 = t175 * cos_post_phi;
    let t177 = t175 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t178 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t179 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t180 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t181 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t182 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t183 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t184 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t185 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t186 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t187 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t188 = (bobbin_v_x * (bobbin_v_x_over_between + t182 + t183 - t180 - t181
        - drum_v_x_over_between)).add_product(bobbin_v_y, bobbin_v_y_over_between + t186 + t187
        - t184 - t185 - drum_v_y_over_between).add_product(drum_v_x, t180 + t181
        + drum_v_x_over_between - bobbin_v_x_over_between - t182 - t183).add_product(drum_v_y, t184
        + t185 + drum_v_y_over_between - bobbin_v_y_over_between - t186 - t187);
    let t189 = t35 * t176;
    let t190 = -t177 - R::literal(-9.81) + t189;
    let t191 = t14 * bobbin_radius_times_winding_force;
    let t192 = (t191 - t176.add_product(t178, cos_plate_phi)).add_product(t37, t176)
        .sub_product(t45, t190);
    let t193 = t15 * bobbin_radius_times_winding_force;
    let t194 = (-t177.add_product(t178, sin_plate_phi) - R::literal(9.81) - R::literal(-9.81)
        - t193 + t189).sub_product(t47, t190).sub_product(t54, t192);
    let t195 = R::literal(3.333_333_333_333_333_5) * t162;
    let t196 = (t191.sub_product(R::literal(0.06), (plate_omega_squared * cos_plate_phi)
        .add_product(cylinder_omega_squared, cos_cylinder_phi)) - t195).sub_product(t20, t168)
        .sub_product(t56, t192).sub_product(t68, t194);
    let t197 = R::literal(3.333_333_333_333_333_5) * t166;
    let t198 = (R::literal(-9.81).sub_product(R::literal(0.06), (plate_omega_squared
        * sin_plate_phi).add_product(cylinder_omega_squared, sin_cylinder_phi)) - t193 - t197)
        .add_product(t21, t168).sub_product(t57, t192).sub_product(t70, t194).sub_product(t81,
        t196);
    let t199 = (-(R::literal(-2_777.777_777_777_778) * t168)).add_product(t83, t196)
        .sub_product(t94, t198);
    let t200 = (cylinder_omega * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
        .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi).add_product(cylinder_x
        * cylinder_omega, sin_cylinder_phi).add_product(rod_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi).sub_product(R::literal(2.0)
        * cylinder_v_y, sin_cylinder_phi).sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
        .sub_product(rod_x * cylinder_omega, sin_cylinder_phi)).sub_product(t18, t162)
        .add_product(t19, t166).add_product(t22, t168).add_product(t23, t169).sub_product(t24, t171)
        .sub_product(t85, t196).sub_product(t96, t198);
    let t201 = t200.sub_product(t105, t199);
    let t202 = R::literal(5.0) * t169;
    let t203 = (-t202).add_product(t179, cos_rod_phi).sub_product(t106, t199).sub_product(t116,
        t201);
    let t204 = R::literal(5.0) * t171;
    let t205 = (-t204).add_product(t179, sin_rod_phi).add_product(t107, t199).sub_product(t118,
        t201).sub_product(t127, t203);
    let t206 = inverse_bobbin_mass * t172;
    let t207 = ((t10 * plate_omega_squared).sub_product(t16, bobbin_radius_times_winding_force)
        + t206).sub_product(t60, t192).sub_product(t73, t194).sub_product(t87, t196)
        .sub_product(t98, t198).sub_product(t109, t199).sub_product(t120, t201).sub_product(t129,
        t203).sub_product(t136, t205);
    let t208 = inverse_bobbin_mass * t174;
    let t209 = (R::literal(-9.81).add_product(t9, plate_omega_squared).add_product(t17,
        bobbin_radius_times_winding_force) - t208).add_product(t62, t192).sub_product(t76, t194)
        .sub_product(t89, t196).sub_product(t100, t198).sub_product(t111, t199).sub_product(t122,
        t201).sub_product(t131, t203).sub_product(t138, t205).sub_product(t143, t207);
    let t210 = (-t188).add_product(t27, t172).sub_product(t28, t174)
        .add_product(R::literal(-9.809_999_999_999_999), bobbin_y_minus_drum_y_over_between)
        .add_product(t144, t207).sub_product(t149, t209)
        .add_product(bobbin_y_minus_drum_y_over_between, R::literal(9.809_999_999_999_999));
    let t211 = ((R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044), cos_post_phi)
        * post_omega_squared).sub_product(t39, t176).sub_product(t49, t190).sub_product(t64, t192)
        .sub_product(t78, t194).sub_product(t91, t196).sub_product(t102, t198).sub_product(t113,
        t199).sub_product(t124, t201).sub_product(t133, t203).sub_product(t140, t205)
        .sub_product(t146, t207).sub_product(t151, t209).sub_product(t156, t210) * t157;
    let t212 = (t210 * t154).sub_product(t156, t211);
    let t213 = (t209 * t147).sub_product(t149, t212).sub_product(t151, t211);
    let t214 = (t207 * t141).sub_product(t143, t213).add_product(t144, t212).sub_product(t146,
        t211);
    let t215 = (t205 * t134).sub_product(t136, t214).sub_product(t138, t213).sub_product(t140,
        t211);
    let t216 = (t203 * t125).sub_product(t127, t215).sub_product(t129, t214).sub_product(t131, t213)
        .sub_product(t133, t211);
    let t217 = (t201 * t114).sub_product(t116, t216).sub_product(t118, t215).sub_product(t120, t214)
        .sub_product(t122, t213).sub_product(t124, t211);
    let t218 = (t199 * t103).sub_product(t105, t217).sub_product(t106, t216).add_product(t107, t215)
        .sub_product(t109, t214).sub_product(t111, t213).sub_product(t113, t211);
    let t219 = (t198 * t92).sub_product(t94, t218).sub_product(t96, t217).sub_product(t98, t214)
        .sub_product(t100, t213).sub_product(t102, t211);
    let t220 = (t196 * t79).sub_product(t81, t219).add_product(t83, t218).sub_product(t85, t217)
        .sub_product(t87, t214).sub_product(t89, t213).sub_product(t91, t211);
    let t221 = (t194 * t66).sub_product(t68, t220).sub_product(t70, t219).sub_product(t73, t214)
        .sub_product(t76, t213).sub_product(t78, t211);
    let t222 = (t192 * t51).sub_product(t54, t221).sub_product(t56, t220).sub_product(t57, t219)
        .sub_product(t60, t214).add_product(t62, t213).sub_product(t64, t211);
    let t223 = (t190 * t43).sub_product(t45, t222).sub_product(t47, t221).sub_product(t49, t211);
    let t224 = (-(t176 * t33)).sub_product(t35, t223).sub_product(t37, t222).sub_product(t35, t221)
        .add_product(t39, t211);
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        .sub_product(R::literal(0.666_666_666_666_666_6), R::literal(-14.714_999_999_999_998)
        .add_product(bobbin_y_minus_drum_y_over_between, t212)).add_product(t30, t212);
    let drum_v_x_dot = (t29 * t212).sub_product(R::literal(0.666_666_666_666_666_6),
        bobbin_x_minus_drum_x_over_between * t212);
    let bobbin_v_y_dot = t208.sub_product(inverse_bobbin_mass, t213).sub_product(t28, t212);
    let bobbin_v_x_dot = (-t206).sub_product(inverse_bobbin_mass, t214).sub_product(t27, t212);
    let rod_omega_dot = (t25 * t216).sub_product(R::literal(4_166.666_666_666_667), t218)
        .sub_product(t26, t215);
    let rod_v_y_dot = t204.sub_product(t24, t217).sub_product(R::literal(5.0), t215);
    let rod_v_x_dot = t202.add_product(t23, t217).sub_product(R::literal(5.0), t216);
    let cylinder_omega_dot = (t168 * R::literal(2_777.777_777_777_778)).sub_product(t20, t220)
        .add_product(t21, t219).sub_product(R::literal(-2_777.777_777_777_778), t218)
        .add_product(t22, t217);
    let cylinder_v_y_dot = t197.sub_product(R::literal(3.333_333_333_333_333_5), t219)
        .add_product(t19, t217);
    let cylinder_v_x_dot = t195.sub_product(R::literal(3.333_333_333_333_333_5), t220)
        .sub_product(t18, t217);
    let plate_omega_dot = (-(bobbin_radius_times_winding_force * R::literal(400.0)))
        .sub_product(t14, t222).add_product(t15, t221).sub_product(t14, t220).add_product(t15, t219)
        .add_product(t16, t214).sub_product(t17, t213);
    let plate_v_y_dot = R::literal(-9.81).sub_product(R::literal(0.833_333_333_333_333_4), t221)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t219)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t213);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t220))
        .sub_product(R::literal(0.833_333_333_333_333_4), t222)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t214);
    let post_omega_dot = (t12 * t223).sub_product(t11, t224).sub_product(t11, t222)
        .add_product(t12, t221).sub_product(t13, t211);
    let post_v_y_dot = R::literal(-9.81).sub_product(R::literal(1.25), t223)
        .sub_product(R::literal(-1.25), t221);
    let post_v_x_dot = (-(R::literal(-1.25) * t222)).sub_product(R::literal(1.25), t224);
    let t225 = (R::literal(7.848) * post_v_y).add_product(R::literal(11.772), plate_v_y)
        .sub_product(t161, cylinder_v_x).add_product(t164, cylinder_v_y).add_product(t167,
        cylinder_omega).add_product(t161, rod_v_x).add_product(t170, rod_v_y).add_product(t173,
        bobbin_v_y).add_product(R::literal(14.715), drum_v_y).add_product(R::literal(0.8)
        * post_v_x, post_v_x_dot).add_product(R::literal(0.8) * post_v_y, post_v_y_dot)
        .add_product(R::literal(0.0027) * post_omega, post_omega_dot).add_product(R::literal(1.2)
        * plate_v_x, plate_v_x_dot).add_product(R::literal(1.2) * plate_v_y, plate_v_y_dot)
        .add_product(R::literal(0.0025) * plate_omega, plate_omega_dot).add_product(R::literal(0.3)
        * cylinder_v_x, cylinder_v_x_dot);
    PowerBalance {
        stored_rate: t225.add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot).add_product(R::literal(0.2)
            * rod_v_y, rod_v_y_dot).add_product(R::literal(0.00024) * rod_omega, rod_omega_dot)
            .add_product(p.bobbin_mass * bobbin_v_x, bobbin_v_x_dot).add_product(p.bobbin_mass
            * bobbin_v_y, bobbin_v_y_dot).add_product(R::literal(1.5) * drum_v_x, drum_v_x_dot)
            .add_product(R::literal(1.5) * drum_v_y, drum_v_y_dot),
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
    let stop_value = (R::literal(0.143) * sin_post_phi).sub_product(R::literal(0.044),
        cos_post_phi);
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

/// `G = dg'/dq'`, values in the order of its pattern. 48 operations.
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
    let t2 = -(R::literal(0.1) * cos_post_phi);
    let t3 = -(R::literal(0.06) * cos_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    [R::literal(1.0), t0, R::literal(1.0), t2, R::literal(-1.0), t0, R::literal(1.0), t1,
        R::literal(-1.0), t2, R::literal(1.0), t3, R::literal(-1.0), t1, R::literal(1.0),
        R::literal(0.06) * sin_cylinder_phi, R::literal(-1.0), t3, R::literal(1.0),
        -(R::literal(0.06) * cos_cylinder_phi), R::literal(-1.0), R::literal(1.0),
        sin_cylinder_phi, -cos_cylinder_phi, -slide, -sin_cylinder_phi, cos_cylinder_phi,
        R::literal(1.0), -(R::literal(0.06) * sin_rod_phi), R::literal(1.0),
        R::literal(0.06) * cos_rod_phi, R::literal(-1.0), -(R::literal(0.01)
        * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi), R::literal(1.0),
        R::literal(-1.0), (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1),
        sin_plate_phi), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        bobbin_x_minus_drum_x_over_between, bobbin_y_minus_drum_y_over_between,
        -bobbin_x_minus_drum_x_over_between, -bobbin_y_minus_drum_y_over_between,
        (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi)]
}
