//! `machinist completions`: shell completions of commands and options.

use clap::{Args, Command, ValueEnum};
use clap_complete::{Shell as Known, generate};

use super::output::print_with;
use crate::failure::Failure;

/// Shells that are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Shell {
    Bash,
    Zsh,
    Fish,
}

#[derive(Debug, Args)]
pub struct Completions {
    /// Shell
    shell: Shell,
}

impl Completions {
    pub fn execute(&self) -> Result<(), Failure> {
        let shell = match self.shell {
            Shell::Bash => Known::Bash,
            Shell::Zsh => Known::Zsh,
            Shell::Fish => Known::Fish,
        };
        let mut text = Vec::new();
        generate(shell, &mut shown(&super::command()), "machinist", &mut text);
        print_with(|out| out.write_all(&text))
    }
}

/// Builds a command line without hidden commands, which shells would offer otherwise.
fn shown(whole: &Command) -> Command {
    Command::new("machinist")
        .version(env!("CARGO_PKG_VERSION"))
        .propagate_version(true)
        .args(whole.get_arguments())
        .subcommands(whole.get_subcommands().filter(|command| !command.is_hide_set()))
}
