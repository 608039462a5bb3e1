//! Groups of commands in `machinist --help`.

use clap::Command;
use clap::builder::StyledStr;

use super::table::{indented, width};

/// Groups in their order, with the commands of each.
pub const GROUPS: [(&str, &[&str]); 6] = [
    ("Everyday", &["new", "check", "run", "plot", "report", "verify"]),
    (
        "Analyse",
        &[
            "modes",
            "response",
            "campbell",
            "spectrum",
            "fatigue",
            "cycle",
            "linearize",
            "sensitivity",
            "gradient",
        ],
    ),
    ("Decide", &["sweep", "scatter", "fit", "improve"]),
    ("Share", &["gen", "compile", "fmu", "import"]),
    ("Look", &["show", "list", "parts", "schema", "explain", "explain-error", "derive", "watch"]),
    ("Project", &["bench", "stability", "studies", "cache", "completions"]),
];

/// Maximum width of the help, as for the help of commands.
const WIDEST: usize = 100;

/// Replaces the list of commands in the help by one in groups. Builds without the feature `derive`
/// have fewer commands.
pub fn grouped(command: Command) -> Command {
    let styles = command.get_styles().clone();
    let (header, literal) = (*styles.get_header(), *styles.get_literal());
    let visible = || command.get_subcommands().filter(|command| !command.is_hide_set());
    let column = visible().map(|command| command.get_name().len()).max().unwrap_or_default() + 4;
    let (space, width) = (" ".repeat(column), width().min(WIDEST));
    let mut text = String::new();
    for (group, names) in GROUPS {
        let found = names.iter().filter_map(|name| command.find_subcommand(name));
        let lines = found.map(|command| {
            let (name, about) = (command.get_name(), command.get_about());
            let about = about.map(ToString::to_string).unwrap_or_default();
            let about = indented(&about, &space, width);
            let gap = " ".repeat(column - 2 - name.len());
            format!("  {literal}{name}{literal:#}{gap}{}", about.trim_start())
        });
        let lines: String = lines.collect();
        let heading = format!("\n{header}{group}:{header:#}\n");
        text.extend([heading, lines]);
    }
    let template = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n{text}\n\
         {header}Options:{header:#}\n{{options}}\n\n\
         `machinist COMMAND --help` explains a command.\n"
    );
    command.help_template(StyledStr::from(template))
}
