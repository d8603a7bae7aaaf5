//! How a particle rests: what is remembered of it from one look to the next.

/// A byte a particle. The looks that found an island calm are counted at the particle in its last slot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mark(u8);

impl Mark {
    const LAST: u8 = 1 << 7;
    const ASLEEP: u8 = 1 << 6;
    const STIRRED: u8 = 1 << 5;
    const LOOKS: u8 = Self::STIRRED - 1;

    /// As it is kept.
    pub fn from_byte(byte: u8) -> Self {
        Self(byte)
    }

    /// As it is kept.
    pub fn to_byte(self) -> u8 {
        self.0
    }

    /// Whether it is in the last slot of its island.
    pub fn is_last(self) -> bool {
        self.0 & Self::LAST != 0
    }

    /// Whether it sleeps, if the rest of its island does.
    pub fn is_asleep(self) -> bool {
        self.0 & Self::ASLEEP != 0
    }

    /// Whether something has moved it, or moves what holds it.
    pub fn is_stirred(self) -> bool {
        self.0 & Self::STIRRED != 0
    }

    /// Looks in a row that found its island calm.
    pub fn looks(self) -> u8 {
        self.0 & Self::LOOKS
    }

    /// With that said of its slot.
    pub fn placed(self, last: bool) -> Self {
        Self(self.0 & !Self::LAST | if last { Self::LAST } else { 0 })
    }

    /// Asleep.
    pub fn sleeping(self) -> Self {
        Self(self.0 | Self::ASLEEP)
    }

    /// Woken: nobody has looked at it yet.
    pub fn awake(self) -> Self {
        Self(self.0 & !(Self::ASLEEP | Self::LOOKS))
    }

    /// Stirred: the next look does not find it calm.
    pub fn stirred(self) -> Self {
        Self(self.0 | Self::STIRRED)
    }

    /// After a look that found so many calm ones in a row.
    pub fn looked_at(self, looks: u8) -> Self {
        Self(self.0 & !(Self::STIRRED | Self::LOOKS) | looks.min(Self::LOOKS))
    }
}

/// When what rests was looked at, and what came of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Watch {
    /// s since the last look.
    pub since: f64,
    /// Islands have fallen asleep, and still are among those that are stepped.
    pub fell_asleep: bool,
}
