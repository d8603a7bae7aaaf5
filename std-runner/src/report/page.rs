//! One self-contained page: a title, sections, pictures, tables; for light and dark screens, and for paper.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::chart::{ChartError, Sheet};

/// The style of every page.
const STYLE: &str = include_str!("page.css");

/// A page. All text is plain: what it has of `<` and `&` is written so that it is shown.
#[derive(Clone, Debug)]
pub struct Page {
    /// Of the page.
    pub title: String,
    /// One or two sentences that say what it is.
    pub lead: String,
    /// From top to bottom.
    pub sections: Vec<Section>,
    /// What made it: program, version, machine, date.
    pub made_by: String,
}

/// A part of a page with a heading.
#[derive(Clone, Debug)]
pub struct Section {
    /// Above it.
    pub heading: String,
    /// From top to bottom.
    pub blocks: Vec<Block>,
}

/// One thing in a section.
#[derive(Clone, Debug)]
pub enum Block {
    /// What is to be remembered of the section: set off from the rest.
    Advice(String),
    /// A paragraph.
    Text(String),
    /// A smaller heading.
    Heading(String),
    /// A picture with a line below it that says what it shows.
    Figure {
        /// As [`Sheet::svg`] makes it: not escaped.
        svg: String,
        /// Below it.
        caption: String,
    },
    /// A table; its first row is the head, and its first column names the rows.
    Table {
        /// All as long as the first one.
        rows: Vec<Vec<String>>,
        /// Above it.
        caption: String,
    },
    /// What is the case: a term, and what there is to say of it.
    Facts(Vec<(String, String)>),
}

impl Block {
    /// Charts with a caption.
    ///
    /// # Errors
    /// If they cannot be drawn.
    pub fn figure(sheet: &Sheet, caption: impl Into<String>) -> Result<Self, ChartError> {
        Ok(Self::Figure { svg: sheet.svg()?, caption: caption.into() })
    }
}

impl Page {
    /// As HTML: one file without references to others.
    #[must_use]
    pub fn html(&self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en-GB" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    // No icon: browsers ask for one otherwise.
                    link rel="icon" href="data:,";
                    title { (self.title) }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    header {
                        h1 { (self.title) }
                        p.lead { (self.lead) }
                    }
                    @if self.sections.len() > 1 { (contents(&self.sections)) }
                    main {
                        @for (number, part) in self.sections.iter().enumerate() { (section(number, part)) }
                    }
                    footer { (self.made_by) }
                }
            }
        };
        page.into_string()
    }
}

/// Where to find each section.
fn contents(sections: &[Section]) -> Markup {
    html! {
        nav { @for (number, section) in sections.iter().enumerate() { a href={ "#section-" (number) } { (section.heading) } " " } }
    }
}

fn section(number: usize, section: &Section) -> Markup {
    html! {
        section id={ "section-" (number) } {
            h2 { (section.heading) }
            @for part in &section.blocks { (block(part)) }
        }
    }
}

fn block(block: &Block) -> Markup {
    html! {
        @match block {
            Block::Advice(text) => p.advice { (text) },
            Block::Text(text) => p { (text) },
            Block::Heading(text) => h3 { (text) },
            Block::Figure { svg, caption } => figure { (PreEscaped(svg)) figcaption { (caption) } },
            Block::Table { rows, caption } => (table(rows, caption)),
            Block::Facts(facts) => dl { @for (term, said) in facts { dt { (term) } dd { (said) } } },
        }
    }
}

fn table(rows: &[Vec<String>], caption: &str) -> Markup {
    html! {
        div.table { table {
            caption { (caption) }
            @if let Some((head, body)) = rows.split_first() {
                thead { tr { @for cell in head { th scope="col" { (cell) } } } }
                tbody { @for row in body { tr {
                    @for (column, cell) in row.iter().enumerate() {
                        @if column == 0 { th scope="row" { (cell) } } @else { td { (cell) } }
                    }
                } } }
            }
        } }
    }
}
