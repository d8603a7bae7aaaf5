//! Columns that line up.

/// Rows of text, every column as wide as its widest cell; the last one is left as it is.
pub(super) fn rows<const COLUMNS: usize>(rows: &[[String; COLUMNS]], indent: usize) -> Vec<String> {
    let width = |column: usize| rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
    let line = |row: &[String; COLUMNS]| {
        let cells = row.iter().enumerate().map(|(column, cell)| format!("{cell:<0$}", width(column).unwrap_or(0)));
        format!("{:indent$}{}", "", cells.collect::<Vec<_>>().join("  ")).trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

/// Numbers with the same digits after the point, as many as show six of the largest, right-aligned; or with exponents,
/// where they are very large or very small.
pub(super) fn numbers(values: &[f64]) -> Vec<String> {
    let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let exponent = if largest > 0.0 { largest.log10().floor() } else { 0.0 };
    let text: Vec<String> = if (-6.0..9.0).contains(&exponent) {
        let decimals = (5.0 - exponent).clamp(0.0, 12.0) as usize;
        values.iter().map(|value| unsigned_zero(format!("{value:.decimals$}"))).collect()
    } else {
        values.iter().map(|value| format!("{value:.5e}")).collect()
    };
    let width = text.iter().map(|text| text.chars().count()).max().unwrap_or(0);
    text.iter().map(|text| format!("{text:>width$}")).collect()
}

/// What rounds to 0 is told as 0 and not as −0.
fn unsigned_zero(text: String) -> String {
    let is_zero = text.chars().all(|character| matches!(character, '-' | '0' | '.'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}
