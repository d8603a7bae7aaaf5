//! The part of a file that an error shows.

use std::sync::Arc;

use miette::{MietteError, MietteSpanContents, NamedSource, SourceCode, SourceSpan, SpanContents};

/// More bytes than this around a place are not shown: a scene that a program wrote may be one line.
const LONGEST: usize = 1000;
/// What is shown before and after a place of which not all is shown, bytes.
const MARGIN: usize = 60;
/// What is underlined at most, bytes.
const UNDERLINED: usize = 120;

/// A file's text, of which little is shown where its lines are long.
#[derive(Debug)]
pub(super) struct Excerpt {
    text: Arc<str>,
    source: NamedSource<Arc<str>>,
}

impl Excerpt {
    pub(super) fn new(file: String, text: &Arc<str>) -> Self {
        Self { text: Arc::clone(text), source: NamedSource::new(file, Arc::clone(text)) }
    }

    /// As much of a span as is underlined.
    pub(super) fn underlined(text: &str, start: usize, end: usize) -> SourceSpan {
        let end = if end - start > UNDERLINED { text.floor_char_boundary(start + UNDERLINED) } else { end };
        SourceSpan::from(start..end)
    }
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let whole = self.source.read_span(span, before, after)?;
        if whole.data().len() <= LONGEST {
            return Ok(whole);
        }
        let (offset, end) = (span.offset(), span.offset() + span.len());
        let line_start = self.text[..offset].rfind('\n').map_or(0, |newline| newline + 1);
        let line_end = self.text[end..].find('\n').map_or(self.text.len(), |length| end + length);
        let from = self.text.floor_char_boundary(offset.saturating_sub(MARGIN)).max(line_start);
        let to = self.text.ceil_char_boundary((end + MARGIN).min(line_end));
        let place = self.source.read_span(span, 0, 0)?;
        let column = place.column() - self.text[from..offset].chars().count().min(place.column());
        let shown = self.text[from..to].as_bytes();
        let name = self.source.name().to_owned();
        Ok(Box::new(MietteSpanContents::new_named(name, shown, (from..to).into(), place.line(), column, 1)))
    }
}
