//! Scene files: read from TOML or JSON, checked, and made into the flat [`Model`].
//!
//! Without the feature `desktop` it touches nothing of the machine: texts come from the caller.

mod checks;
mod error;
mod excerpt;
mod file;
mod generators;
mod max_error;
pub mod model;
mod names;
mod obj;
#[cfg(feature = "desktop")]
mod overrides;
mod particle;
mod plane;
mod read;
mod schema;
mod selector;
mod settings;
mod size;
mod spring;
mod starters;
mod time_step;

use std::ops::Add;
use std::path::Path;

use model::Model;

use error::Problem;
use file::SceneFile;
use generators::{Generator, Mesh};
use read::Source;
use size::Size;

pub use error::SceneError;
pub use max_error::MaxError;
pub use names::{CollisionForm, Precision, StepperName};
#[cfg(feature = "desktop")]
pub use overrides::Overrides;
#[cfg(feature = "desktop")]
pub use read::text_of_file;
pub use read::{Texts, Unreadable};
pub use schema::schema;
pub use settings::Settings;
pub use starters::Starter;
pub use time_step::TimeStep;

/// A scene that was read and found sound.
#[derive(Clone, Debug)]
pub struct Scene {
    settings: Settings,
    file: SceneFile,
    meshes: Vec<Mesh>,
    source: Source,
}

impl Scene {
    /// Reads and checks the file at `path`, and the mesh files it names. The ending says the format: `.toml` or `.json`.
    ///
    /// # Errors
    /// If anything in it cannot be run; the error names the place, the value and the remedy.
    #[cfg(feature = "desktop")]
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::of(path, &mut text_of_file)
    }

    /// Reads and checks the scene at `path`, whose ending says the format, where `text` gives the text of it and of the
    /// mesh files that it names, told what each file should be.
    ///
    /// # Errors
    /// As if the texts stood in files.
    pub fn of(path: &Path, text: Texts<'_>) -> Result<Self, SceneError> {
        let source = Source::of(path, text)?;
        let mut file: SceneFile = source.parse()?;
        let stem = source.path().file_stem().unwrap_or_default().to_string_lossy();
        let settings = file.settings(&stem);
        let meshes = std::mem::take(&mut file.mesh)
            .into_iter()
            .enumerate()
            .map(|(index, entry)| entry.load(index, &source, text))
            .collect::<Result<_, _>>()?;
        let scene = Self { settings, file, meshes, source };
        scene.check().map_err(|problem| scene.source.problem(problem))?;
        Ok(scene)
    }

    /// How the scene is run.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Puts the settings that a command line gives in place of the scene's own.
    ///
    /// # Errors
    /// If one of them cannot be run; the error names its flag, and nothing is changed.
    #[cfg(feature = "desktop")]
    pub fn apply(&mut self, overrides: &Overrides) -> Result<(), SceneError> {
        self.settings = self.settings.with(overrides)?;
        Ok(())
    }

    /// All its particles, springs and planes.
    ///
    /// # Errors
    /// If they are more than 2³² − 1, or need more memory than is available.
    #[cfg(feature = "desktop")]
    pub fn model(&self) -> Result<Model, SceneError> {
        self.model_within(size::available_memory())
    }

    /// As [`Scene::model`], for a run that may take `available` bytes.
    ///
    /// # Errors
    /// If there are more than 2³² − 1 particles or springs, or they need more than `available` bytes.
    pub fn model_within(&self, available: u64) -> Result<Model, SceneError> {
        let size = self.size();
        size.check(&self.source.path().display().to_string(), available)?;
        let mut model = Model::default();
        model.particles.reserve_exact(size.particles as usize);
        model.springs.reserve_exact(size.springs as usize);
        for particle in &self.file.particle {
            particle.expand(&mut model);
        }
        let mut firsts = Vec::new();
        for (.., generator) in self.generators() {
            firsts.push(model.particles.len() as u32);
            generator.particles(&mut model.particles);
        }
        model.springs.extend(self.file.spring.iter().map(|spring| spring.expand(&model.particles)));
        for ((.., generator), first) in self.generators().zip(firsts) {
            generator.springs(first, &mut model.springs);
        }
        model.planes.extend(self.file.plane.iter().map(plane::Plane::expand));
        Ok(model)
    }

    /// About how many bytes of memory a run of it takes.
    #[must_use]
    pub fn bytes_needed(&self) -> u128 {
        self.size().bytes()
    }

    /// The key and number of each generator, in the order that their particles are numbered.
    fn generators(&self) -> impl Iterator<Item = (&'static str, usize, &dyn Generator)> {
        fn of<'a, T: Generator>(
            key: &'static str,
            list: &'a [T],
        ) -> impl Iterator<Item = (&'static str, usize, &'a dyn Generator)> {
            list.iter().enumerate().map(move |(index, item)| (key, index, item as &dyn Generator))
        }
        of("rope", &self.file.rope)
            .chain(of("cloth", &self.file.cloth))
            .chain(of("block", &self.file.block))
            .chain(of("cloud", &self.file.cloud))
            .chain(of("mesh", &self.meshes))
    }

    fn size(&self) -> Size {
        let written = Size { particles: self.file.particle.len() as u128, springs: self.file.spring.len() as u128 };
        self.generators().map(|(.., generator)| generator.size()).fold(written, Size::add)
    }

    fn check(&self) -> Result<(), Problem> {
        self.settings.check()?;
        check_each("particle", &self.file.particle, particle::Particle::check)?;
        check_each("plane", &self.file.plane, plane::Plane::check)?;
        for (key, index, generator) in self.generators() {
            generator.check().map_err(|problem| problem.inside_item(key, index))?;
        }
        let particles = u64::try_from(self.size().particles).unwrap_or(u64::MAX);
        check_each("spring", &self.file.spring, |spring| spring.check(particles))
    }
}

fn check_each<T>(key: &str, list: &[T], check: impl Fn(&T) -> Result<(), Problem>) -> Result<(), Problem> {
    list.iter().enumerate().try_for_each(|(index, item)| check(item).map_err(|problem| problem.inside_item(key, index)))
}
