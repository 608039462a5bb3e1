//! Structure of reduced scenes: constant and linear functions, and parts that are apart.

use machinist_codegen::lower::structure::Structure;

use crate::reduced::{CHAIN, GIN, Spec, pair, scene, states};

#[test]
fn structure_tells_what_is_constant_linear_and_apart() {
    let chain = Structure::of(&Spec::new(CHAIN).needed());
    assert!(chain.constant_mass && chain.diagonal_mass && chain.is_linear() && !chain.autonomous);
    assert_eq!(chain.subsystems.len(), 1);
    assert_eq!(chain.constant_jacobian.0, chain.constant_jacobian.1);

    // A motor with an independent oscillator beside it: two parts, one of them linear.
    let beside = GIN.replace(
        "[run]",
        "[units.a]\nunit = \"rotor\"\n[units.b]\nunit = \"rotor\"\n\
         [units.spring]\nunit = \"coupling\"\n\
         [[joints]]\nconnect = [\"a.shaft\", \"spring.driving\"]\n\
         [[joints]]\nconnect = [\"b.shaft\", \"spring.driven\"]\n[run]",
    );
    let spec = Spec::new(&format!("{beside}other = \"spring.torque\"\n"));
    let program = spec.needed();
    let names = states(&program);
    let structure = Structure::of(&program);
    let named = |part: &[u32]| part.iter().map(|at| names[*at as usize]).collect::<Vec<_>>();
    assert_eq!(structure.subsystems.len(), 2, "{names:?}");
    assert_eq!(named(&structure.linear_part), ["spring.twist", "a.omega", "b.omega"]);
    assert!(structure.subsystems.contains(&structure.linear_part));
    // The twist of the gin is linear in its speeds, whose rates are not.
    assert!(named(&structure.linear_rows).contains(&"coupling.twist"));
    assert!(!structure.is_linear());

    let chain = Structure::of(&scene("pendulum_chain"));
    assert!(!chain.constant_mass && !chain.diagonal_mass && chain.autonomous);
    assert_eq!(chain.linear_part, [0_u32; 0]);
}

#[test]
fn a_rate_that_jumps_at_a_state_is_not_linear_though_its_slopes_are_constant() {
    let structure = |force| Structure::of(&pair(force).needed());
    assert!(structure("-2 [N m/rad]*(a.phi - b.phi)").is_linear());
    for force in ["-2 [N m]*sign(a.phi - b.phi)", "-2 [N m/rad]*max(a.phi - b.phi, 0)"] {
        assert!(!structure(force).is_linear(), "{force}");
    }
    let dry = structure("-2 [N m]*sign(a.phi - b.phi)");
    assert_eq!(dry.constant_jacobian.0, dry.constant_jacobian.1);
}

#[test]
fn parts_that_only_a_jump_joins_are_not_apart() {
    let beside = |force: &str| {
        let program = Spec::new(
            &GIN.replace(
                "[run]",
                &format!(
                    "[units.beside]\nunit = \"rotor\"\n[[forces]]\nport = \"beside.shaft\"\n\
                     expression = \"{force} - 1 [N m s/rad]*beside.omega\"\n[run]"
                ),
            )
            .replace("[outputs]\n", "[outputs]\nbeside = \"beside.omega\"\n"),
        )
        .needed();
        let structure = Structure::of(&program);
        let name = |entry: &u32| states(&program)[*entry as usize].to_owned();
        let part: Vec<String> = structure.linear_part.iter().map(name).collect();
        (structure.subsystems.len(), part)
    };
    assert_eq!(beside("2 [N m]"), (2, vec!["beside.omega".to_owned()]));
    assert_eq!(beside("2 [N m]*sign(cylinder.omega)"), (1, vec![]));
    // Linear, but not a part that can be solved first, because it follows the gin, which is not
    // linear.
    assert_eq!(beside("2 [N m s/rad]*cylinder.omega"), (1, vec![]));
}

#[test]
fn a_mass_matrix_may_be_constant_and_full_or_diagonal_and_of_the_state() {
    let structure = |kinetic: &str| {
        let spec = Spec::new(&format!(
            "[scene]\nname = \"pair\"\n[units.pair]\nunit = \"pair\"\n\
             [define.pair.coordinates.a]\nunit = \"rad\"\n[define.pair.coordinates.b]\nunit = \"rad\"\n\
             [define.pair.parameters.mass]\nvalue = 2.0\nunit = \"kg m^2\"\n\
             [define.pair.parameters.stiffness]\nvalue = 3.0\nunit = \"N m\"\n\
             [define.pair.energy]\nkinetic = \"{kinetic}\"\n\
             potential = \"stiffness*(a^2 + b^2)/2\"\n\
             [outputs]\na = \"pair.a\"\nb = \"pair.b\"\n\
             [run]\nuntil = 1.0\npoints = 11\nrtol = 1e-8\nmethod = \"tsit45\"\n"
        ));
        let structure = Structure::of(&spec.needed());
        (structure.constant_mass, structure.diagonal_mass, structure.is_linear())
    };
    assert_eq!(structure("mass*(a_dot^2 + b_dot^2)/2"), (true, true, true));
    assert_eq!(structure("mass*(a_dot^2 + a_dot*b_dot + b_dot^2)/2"), (true, false, true));
    assert_eq!(structure("mass*(a_dot^2 + b_dot^2*(2 + sin(a)))/2"), (false, true, false));
    assert_eq!(structure("mass*(a_dot^2 + a_dot*b_dot*sin(a) + b_dot^2)/2"), (false, false, false));
}
