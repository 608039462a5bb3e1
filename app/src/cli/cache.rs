//! `machinist cache`: the cache of derived scenes.

use clap::Args;

use super::output::print;
use crate::deriving::Cache;
use crate::failure::Failure;

#[derive(Debug, Args)]
pub struct CacheCommand {
    /// Delete all entries
    #[arg(long)]
    clear: bool,
}

impl CacheCommand {
    #[allow(clippy::unnecessary_wraps, reason = "commands are alike")]
    pub fn execute(&self) -> Result<(), Failure> {
        let cache = Cache::of_user();
        let Some(folder) = cache.folder() else {
            return print("there is no cache folder\n");
        };
        let folder = folder.display();
        if self.clear {
            let gone = cache.keep_within(0);
            return print(&format!(
                "{folder}: deleted {} entries, {} bytes\n",
                gone.entries, gone.bytes
            ));
        }
        let size = cache.size();
        print(&format!("{folder}: {} entries, {} bytes\n", size.entries, size.bytes))
    }
}
