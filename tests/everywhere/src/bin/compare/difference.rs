//! Where two machines part.

use crate::machine::Machine;

const COMPONENTS: [&str; 6] = ["position x", "position y", "position z", "velocity x", "velocity y", "velocity z"];

/// The first step, particle and component in which a row differs on two machines, in words.
///
/// # Errors
/// If one of them does not answer.
pub fn first_difference(row: &str, machine: &Machine, right: &Machine) -> Result<String, String> {
    let [ours, theirs] = [machine.ask(row)?, right.ask(row)?];
    let longest = ours.len().max(theirs.len());
    let Some(step) = (0..longest).find(|step| ours.get(*step) != theirs.get(*step)) else {
        return Ok("stepped once more it does not differ: its bits change from run to run".to_owned());
    };
    let question = format!("{row} {}", step + 1);
    let [our_state, their_state] = [machine.ask(&question)?, right.ask(&question)?];
    let first = format!("first in step {}", step + 1);
    for (particle, (our, their)) in our_state.iter().zip(&their_state).enumerate() {
        let components = our.split(' ').zip(their.split(' ')).zip(COMPONENTS);
        if let Some(((our, their), component)) = components.into_iter().find(|((our, their), _)| our != their) {
            let [our, their] = [our, their].map(told);
            return Ok(format!("{first}, particle {particle}, {component}: {our}, where {} has {their}", right.name));
        }
    }
    let [our, their] = [&ours, &theirs].map(|steps| steps.get(step).map_or("nothing", String::as_str));
    Ok(format!("{first}: {our}, where {} has {their}", right.name))
}

/// A number and its bits.
fn told(bits: &str) -> String {
    u64::from_str_radix(bits, 16)
        .map_or_else(|_| bits.to_owned(), |number| format!("{:?} ({bits})", f64::from_bits(number)))
}
