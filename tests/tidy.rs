//! The rules of the house that a machine can check: borders between folders, headers, sizes, unsafe code.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Longest file and longest function, in lines.
const FILE_LIMIT: usize = 700;
const FUNCTION_LIMIT: usize = 80;

/// Crates that only the shell may name.
const SHELL_CRATES: [&str; 5] = [
    "sdl2",
    "glow",
    "imgui",
    "imgui_sdl2_support",
    "imgui_glow_renderer",
];

/// The files of the program that may hold unsafe code, to call OpenGL and the library that talks to X servers, and two of
/// tests: an allocator that watches the system's, and a call of what `sdl2` does not wrap.
const UNSAFE_FILES: [&str; 6] = [
    "src/shell/render/gl.rs",
    "src/shell/render/gl/crowd.rs",
    "src/shell/render/gl/pixels.rs",
    "src/shell/xlib.rs",
    "tests/shell/heap.rs",
    "tests/shell/virtual_pad.rs",
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// A source file: its path from the project's directory, its text, and its text without comments and literals.
struct Source {
    path: String,
    text: String,
    code: String,
}

fn sources(top: &str) -> Vec<Source> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(top)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).unwrap();
                let name = path
                    .strip_prefix(root())
                    .unwrap()
                    .to_str()
                    .unwrap()
                    .replace('\\', "/");
                found.push(Source {
                    path: name,
                    code: code_only(&text),
                    text,
                });
            }
        }
    }
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

/// The folders of `src`, in the order in which `src/lib.rs` lists them.
fn modules() -> Vec<String> {
    let lib = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    let name = |line: &str| {
        Some(
            line.strip_prefix("pub mod ")?
                .strip_suffix(';')?
                .to_string(),
        )
    };
    lib.lines().filter_map(name).collect()
}

/// Blanks comments and the insides of string and character literals, and keeps every line end.
fn code_only(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut code = String::with_capacity(text.len());
    let mut i = 0;
    while i < chars.len() {
        let end = skipped(&chars, i);
        if end == i {
            code.push(chars[i]);
            i += 1;
        } else {
            code.extend(
                chars[i..end]
                    .iter()
                    .map(|&c| if c == '\n' { c } else { ' ' }),
            );
            i = end;
        }
    }
    code
}

/// Where the comment or literal that starts at `i` ends; `i` itself if none starts there.
fn skipped(chars: &[char], i: usize) -> usize {
    let at = |i: usize| chars.get(i).copied().unwrap_or('\0');
    let in_word = i > 0 && (at(i - 1).is_alphanumeric() || at(i - 1) == '_');
    match (at(i), at(i + 1)) {
        ('/', '/') => (i..chars.len())
            .find(|&j| chars[j] == '\n')
            .unwrap_or(chars.len()),
        ('/', '*') => block_comment_end(chars, i),
        ('"', _) => string_end(chars, i + 1),
        ('r', '"' | '#') if !in_word || at(i - 1) == 'b' => raw_string_end(chars, i),
        ('\'', '\\') => (i + 3..chars.len())
            .find(|&j| chars[j] == '\'')
            .map_or(chars.len(), |j| j + 1),
        ('\'', c) if c != '\'' && at(i + 2) == '\'' => i + 3,
        _ => i,
    }
}

fn block_comment_end(chars: &[char], start: usize) -> usize {
    let (mut depth, mut i) = (0, start);
    while i + 1 < chars.len() {
        match (chars[i], chars[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    chars.len()
}

fn string_end(chars: &[char], mut i: usize) -> usize {
    while i < chars.len() && chars[i] != '"' {
        i += if chars[i] == '\\' { 2 } else { 1 };
    }
    (i + 1).min(chars.len())
}

fn raw_string_end(chars: &[char], start: usize) -> usize {
    let hashes = chars[start + 1..].iter().take_while(|&&c| c == '#').count();
    if chars.get(start + 1 + hashes) != Some(&'"') {
        return start; // a raw identifier
    }
    let closes = |j: usize| {
        chars[j] == '"'
            && chars[j + 1..]
                .iter()
                .take(hashes)
                .filter(|&&c| c == '#')
                .count()
                == hashes
    };
    (start + 2 + hashes..chars.len())
        .find(|&j| closes(j))
        .map_or(chars.len(), |j| j + 1 + hashes)
}

/// The words of a piece of code.
fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|word| !word.is_empty())
}

/// What `crate::` paths of this code name first, groups as `use crate::{a, b::c}` included.
fn crate_names(code: &str) -> BTreeSet<String> {
    let compact: String = code.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut names = BTreeSet::new();
    for (at, prefix) in compact.match_indices("crate::") {
        let rest = compact[at + prefix.len()..].trim_start();
        let Some(group) = rest.strip_prefix('{') else {
            names.extend(words(rest).next().map(str::to_string));
            continue;
        };
        let (mut depth, mut start) = (1, true);
        for token in group.split_inclusive(['{', '}', ',']) {
            if start && depth == 1 {
                names.extend(words(token).next().map(str::to_string));
            }
            match token.chars().last() {
                Some('{') => depth += 1,
                Some('}') => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                break;
            }
            start = depth == 1;
        }
    }
    names
}

/// The functions of a file that are longer than the limit, as `name at line n: m lines`.
fn long_functions(code: &str) -> Vec<String> {
    let lines: Vec<&str> = code.lines().collect();
    let mut found = Vec::new();
    for (first, line) in lines.iter().enumerate() {
        let mut after_fn = words(line).skip_while(|&word| word != "fn");
        let Some(name) = after_fn.nth(1) else {
            continue;
        };
        let length = function_length(&lines[first..]);
        if length > FUNCTION_LIMIT {
            found.push(format!("{name} at line {}: {length} lines", first + 1));
        }
    }
    found
}

/// Lines from the first to the one with the brace that closes the body; 0 without a body.
fn function_length(lines: &[&str]) -> usize {
    let (mut depth, mut brackets, mut opened) = (0i32, 0i32, false);
    for (index, line) in lines.iter().enumerate() {
        for c in line.chars() {
            match c {
                '{' => (depth, opened) = (depth + 1, true),
                '}' => depth -= 1,
                '(' | '[' => brackets += 1,
                ')' | ']' => brackets -= 1,
                ';' if !opened && brackets == 0 => return 0,
                _ => {}
            }
            if opened && depth == 0 {
                return index + 1;
            }
        }
    }
    lines.len()
}

/// Fails with every complaint at once.
fn expect_none(complaints: Vec<String>) {
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

fn all_sources() -> Vec<Source> {
    ["src", "tests", "benches"]
        .into_iter()
        .filter(|top| root().join(top).exists())
        .flat_map(sources)
        .collect()
}

#[test]
fn a_folder_names_only_itself_and_those_above_it() {
    let order = modules();
    let place = |name: &str| order.iter().position(|module| module == name);
    let mut complaints = Vec::new();
    for source in sources("src") {
        let own = source.path["src/".len()..]
            .split(['/', '.'])
            .next()
            .unwrap()
            .to_string();
        let Some(own_place) = place(&own) else {
            continue;
        };
        for name in crate_names(&source.code) {
            match place(&name) {
                Some(other) if other > own_place => complaints.push(format!(
                    "{}: names {name}, which is below {own}",
                    source.path
                )),
                Some(_) => {}
                None => complaints.push(format!(
                    "{}: crate::{name} is no folder of src/lib.rs",
                    source.path
                )),
            }
        }
    }
    expect_none(complaints);
}

#[test]
fn only_the_shell_names_its_crates() {
    let mut complaints = Vec::new();
    for source in all_sources() {
        let allowed = source.path.starts_with("src/shell/")
            || source.path.starts_with("tests/shell")
            || source.path == "src/main.rs";
        for name in words(&source.code)
            .filter(|word| !allowed && SHELL_CRATES.contains(word))
            .collect::<BTreeSet<_>>()
        {
            complaints.push(format!("{}: names {name}", source.path));
        }
    }
    expect_none(complaints);
}

#[test]
fn the_core_touches_no_files_and_reads_no_clock() {
    let mut complaints = Vec::new();
    for Source { path, code, .. } in sources("src") {
        // The program's edge (cli, main) and the window; the core has levels alone to read and write.
        let shell = ["src/shell/", "src/cli", "src/main.rs"]
            .iter()
            .any(|edge| path.starts_with(edge));
        if !shell
            && !path.starts_with("src/level/")
            && (code.contains("std::fs") || code.contains("fs::"))
        {
            complaints.push(format!("{path}: touches files"));
        }
        if !shell && words(&code).any(|word| word == "Instant" || word == "SystemTime") {
            complaints.push(format!("{path}: reads a clock"));
        }
    }
    expect_none(complaints);
}

#[test]
fn the_simulation_computes_the_same_everywhere() {
    // IEEE + - * / and sqrt only: these come from the platform's library, fuse two roundings, or are not stable.
    let methods = [
        "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "exp", "ln", "powf",
        "powi", "cbrt", "hypot", "mul_add",
    ];
    let hashers = ["DefaultHasher", "RandomState"];
    let mut complaints = Vec::new();
    for Source { path, code, .. } in sources("src") {
        // The follow camera is picture; nothing of the simulation reads it.
        if path == "src/game/camera.rs"
            || !["geom/", "mesh/", "motion/", "level/", "game/"]
                .iter()
                .any(|folder| path["src/".len()..].starts_with(folder))
        {
            continue;
        }
        complaints.extend(
            methods
                .iter()
                .filter(|name| code.contains(&format!(".{name}(")))
                .map(|name| format!("{path}: .{name}()")),
        );
        complaints.extend(
            words(&code)
                .find(|word| hashers.contains(word))
                .map(|word| format!("{path}: {word}")),
        );
    }
    expect_none(complaints);
}

#[test]
fn every_file_has_a_header_and_a_bearable_length() {
    let mut complaints = Vec::new();
    for Source { path, text, .. } in all_sources() {
        if !text.starts_with("//! ") {
            complaints.push(format!("{path}: does not start with a //! header"));
        }
        let lines = text.lines().count();
        if lines > FILE_LIMIT {
            complaints.push(format!("{path}: {lines} lines"));
        }
    }
    expect_none(complaints);
}

#[test]
fn no_function_is_longer_than_a_screen_and_a_half() {
    let long = |source: Source| {
        long_functions(&source.code)
            .into_iter()
            .map(move |found| format!("{}: {found}", source.path))
    };
    expect_none(all_sources().into_iter().flat_map(long).collect());
}

#[test]
fn unsafe_code_is_in_one_place() {
    let mut complaints = Vec::new();
    for Source { path, code, .. } in all_sources() {
        if !UNSAFE_FILES.contains(&path.as_str()) && words(&code).any(|word| word == "unsafe") {
            complaints.push(format!("{path}: unsafe"));
        }
    }
    let lib = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    if !lib.contains("#![deny(unsafe_code)]") {
        complaints.push("src/lib.rs: does not deny unsafe code".into());
    }
    expect_none(complaints);
}

#[test]
fn the_readme_maps_every_folder() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let mut complaints = Vec::new();
    for name in modules() {
        if !["/", ".rs"]
            .iter()
            .any(|end| readme.contains(&format!("{name}{end}")))
        {
            complaints.push(format!("README.md: does not map src/{name}"));
        }
    }
    for folder in folders_at_the_top() {
        if !readme.contains(&format!("{folder}/")) {
            complaints.push(format!("README.md: does not map {folder}/"));
        }
    }
    expect_none(complaints);
}

fn folders_at_the_top() -> Vec<String> {
    let is_ours = |path: &Path| {
        path.is_dir()
            && path
                .file_name()
                .is_some_and(|name| name != "target" && name != ".git")
    };
    let entries = fs::read_dir(root())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries
        .filter(|path| is_ours(path))
        .map(|path| path.file_name().unwrap().to_str().unwrap().to_string())
        .collect()
}

#[test]
fn the_checks_see_what_they_look_for() {
    let tricky = "fn a() { \"}}}\"; '}'; /* } /* } */ } */ } // }\nfn b<'a>(x: [u8; 2]) -> &'a str;\nlet r = r#\"\"}\"#;";
    let code = code_only(tricky);
    assert_eq!(code.matches('}').count(), 1, "{code}");
    assert_eq!(code.lines().count(), 3);
    assert_eq!(function_length(&code.lines().collect::<Vec<_>>()), 1);
    assert_eq!(function_length(&["fn b<'a>(x: [u8; 2]) -> &'a str;"]), 0);
    let long = format!("fn long() {{\n{}}}\n", "    x();\n".repeat(FUNCTION_LIMIT));
    assert_eq!(
        long_functions(&long),
        [format!("long at line 1: {} lines", FUNCTION_LIMIT + 2)]
    );
    let names =
        crate_names("use crate::{mesh::{Mesh, game}, tune::Tuning, level}; crate::geom::Point");
    assert_eq!(
        names.into_iter().collect::<Vec<_>>(),
        ["geom", "level", "mesh", "tune"]
    );
}
