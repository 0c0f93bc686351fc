//! A progress bar on standard error, where that is a terminal.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use planarium::run::Run;
use std::io::{IsTerminal, stderr};
use std::time::{Duration, Instant};

/// How long a drawing of the bar stands.
const STANDS: Duration = Duration::from_millis(100);

/// Shows how far a run has come towards its most iterations.
pub struct Progress {
    bar: Option<ProgressBar>,
    drawn: Instant,
}

impl Progress {
    pub fn new(run: &dyn Run) -> Self {
        let bar = stderr().is_terminal().then(|| {
            let target = ProgressDrawTarget::stderr();
            let style = ProgressStyle::with_template("{bar:30} {human_pos}/{human_len} iterations  {elapsed}  {msg}")
                .expect("the template is well-formed");
            ProgressBar::with_draw_target(Some(run.max_iterations()), target).with_style(style)
        });
        Self { bar, drawn: Instant::now() }
    }

    /// Draws the bar anew where it is time.
    pub fn show(&mut self, run: &dyn Run) {
        let is_due = |_: &&ProgressBar| self.drawn.elapsed() >= STANDS;
        if let Some(bar) = self.bar.as_ref().filter(is_due) {
            self.drawn = Instant::now();
            bar.set_message(format!("{}, {} vertices", run.phase().as_str(), run.vertex_count()));
            bar.set_position(run.iterations());
        }
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
