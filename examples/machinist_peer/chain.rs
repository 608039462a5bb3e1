//! The spec of a chain of pendulums of any length, as the scenes `m6_2` to `m6_10` have
//! it: emitted chains get long, so those of 20 and 40 links are only derived here.

use std::fmt::Write as _;

/// The spec of a chain of so many links.
pub fn spec(links: usize) -> String {
    let each = |line: &dyn Fn(usize) -> String| (1..=links).map(line).collect::<String>();
    let sum =
        |term: &dyn Fn(usize) -> String| (1..=links).map(term).collect::<Vec<_>>().join(" + ");
    let mut text = format!(
        "[scene]\nname = \"m6_{links}\"\ntitle = \"Benchmark M6: planar pendulum of {links} links\"\n\
         source = \"Benchmark models of textile-machine dynamics.\"\n\n\
         [units.chain]\nunit = \"chain\"\n\n[initial]\n"
    );
    text += &each(&|i| format!("\"chain.theta_{i}\" = \"pi/2\"\n"));
    text += "\n[outputs]\n";
    text += &each(&|i| format!("theta_{i} = \"chain.theta_{i}\"\n"));
    text += &each(&|i| format!("omega_{i} = \"chain.omega_{i}\"\n"));
    text += "\n[tunable]\nparameters = []\n\n[run]\nuntil = 5.0\npoints = 501\nrtol = 1e-8\n\
             method = \"auto\"\n\n[define.chain.unit]\nname = \"chain\"\n";
    let _ = writeln!(text, "title = \"Planar pendulum of {links} links\"\n");
    text += &each(&|i| {
        format!(
            "[define.chain.coordinates.theta_{i}]\nunit = \"rad\"\ndoc = \"angle of link {i}\"\n\
             velocity = \"omega_{i}\"\nvelocity_scale = 5.0\n\n"
        )
    });
    text += "[define.chain.parameters]\n\
             mass = { value = 1.0, unit = \"kg\", doc = \"mass at the end of each link\" }\n\
             length = { value = 1.0, unit = \"m\", doc = \"length of each link\" }\n\
             gravity = { value = 9.81, unit = \"m/s^2\", doc = \"acceleration of free fall\" }\n\n";
    text += &each(&|i| {
        let helper = |name: &str, of: &str, sign: &str, unit: &str| {
            let before = if i == 1 { String::new() } else { format!("{name}_{} ", i - 1) };
            let sign = if i == 1 && sign == "+" { "" } else { sign };
            format!(
                "[define.chain.helpers.{name}_{i}]\nexpression = \"{before}{sign} {of}\"\n\
                 unit = \"{unit}\"\ndoc = \"of mass {i}\"\n\n"
            )
        };
        [
            helper("u", &format!("length*cos(theta_{i})*omega_{i}"), "+", "m/s"),
            helper("v", &format!("length*sin(theta_{i})*omega_{i}"), "+", "m/s"),
            helper("height", &format!("length*cos(theta_{i})"), "-", "m"),
        ]
        .concat()
    });
    let kinetic = sum(&|i| format!("u_{i}^2 + v_{i}^2"));
    let potential = sum(&|i| format!("height_{i}"));
    let _ = write!(
        text,
        "[define.chain.energy]\nkinetic = \"mass/2*({kinetic})\"\n\
         potential = \"mass*gravity*({potential})\"\n"
    );
    text
}
