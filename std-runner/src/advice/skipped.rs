//! The plan of a world in plain words.

use hooke::{Coverage, Plan};

use crate::units::{count, counted};

/// What every step computes.
#[must_use]
pub fn needed(plan: &Plan) -> Vec<String> {
    let mut lines = Vec::new();
    if plan.gravity {
        lines.push("gravity".to_owned());
    }
    if plan.attached > 0 {
        let damped = match plan.damped {
            Coverage::None => "none of them damped",
            Coverage::Some => "some of them damped",
            Coverage::All => "all of them damped",
        };
        let springs = counted(u64::from(plan.springs - plan.idle), "spring");
        lines.push(format!("the forces of {springs}, {damped}, on {}", counted(u64::from(plan.attached), "particle")));
    }
    if plan.planes > 0 {
        lines.push(format!("hits on {}", counted(u64::from(plan.planes), "plane")));
    }
    lines
}

/// What no step computes, and why.
#[must_use]
pub fn skipped(plan: &Plan) -> Vec<String> {
    let mut lines = Vec::new();
    if !plan.gravity {
        lines.push("gravity: it is 0".to_owned());
    }
    let of_one_mass = plan.of_one_mass.1 - plan.of_one_mass.0;
    if of_one_mass > 1 {
        lines.push(format!("reading the masses of {}: they are the same", counted(u64::from(of_one_mass), "particle")));
    }
    if plan.springs == 0 {
        lines.push("spring forces: there are no springs".to_owned());
    } else {
        if plan.free() > 0 {
            let free = plan.free();
            let pulls = if free == 1 { "no spring pulls at it" } else { "no spring pulls at them" };
            lines.push(format!(
                "spring forces on {} of {}: {pulls}",
                count(u64::from(free)),
                counted(u64::from(plan.particles), "particle")
            ));
        }
        if plan.idle > 0 {
            lines.push(format!(
                "spring forces of {} of {}: they lie between particles that are held",
                count(u64::from(plan.idle)),
                counted(u64::from(plan.springs), "spring")
            ));
        }
        if plan.on_diagonals > 0 {
            lines.push(format!(
                "gathering the ends of {} of {}: they lie a constant number of particles apart",
                count(u64::from(plan.on_diagonals)),
                counted(u64::from(plan.springs), "spring")
            ));
        }
        if plan.renumbered > 0 {
            lines.push(format!(
                "reaching far for the ends of springs: inside, {} are in an order in which those are at most {} apart, \
                 not {} as they are numbered",
                counted(u64::from(plan.renumbered), "particle"),
                count(u64::from(plan.reach)),
                count(u64::from(plan.reach_by_number))
            ));
        }
        if plan.damped == Coverage::None {
            lines.push("spring damping: no spring is damped, so the forces read no velocities".to_owned());
        }
    }
    if plan.planes == 0 {
        lines.push("hits: there are no planes".to_owned());
    }
    lines
}
