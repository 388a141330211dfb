//! What the report was measured on.

use std::fs;
use std::process::Command;

/// The machine and the compiler in a sentence.
pub fn name() -> String {
    let processor =
        field("/proc/cpuinfo", "model name").unwrap_or_else(|| std::env::consts::ARCH.to_string());
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get());
    let memory = field("/proc/meminfo", "MemTotal")
        .and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    let memory = memory.map_or(String::new(), |kib| format!(", {:.0} GB", kib / 1e6));
    let compiler = Command::new("rustc").arg("--version").output().ok();
    let compiler = compiler.map_or(String::new(), |out| {
        String::from_utf8_lossy(&out.stdout).trim().to_string()
    });
    format!(
        "{processor}, {cores} cores{memory}, {}, {compiler}",
        std::env::consts::OS
    )
}

/// The first value of a name in a file of `name: value` lines.
fn field(file: &str, name: &str) -> Option<String> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find(|line| line.starts_with(name))?;
    Some(line.split(':').nth(1)?.trim().to_string())
}

/// The version of a crate that this was built with, from the lock file.
pub fn version(crate_name: &str) -> &'static str {
    let lock = include_str!("../Cargo.lock");
    let after = lock
        .split(&format!("name = \"{crate_name}\"\nversion = \""))
        .nth(1);
    after
        .and_then(|rest| rest.split('"').next())
        .unwrap_or("unknown")
}
