// Remedies in the words of the page: its fields and buttons. Options with neither appear as options of the program.
#pragma once

#include <string>

#include "base/message.h"
#include "report/json.h"

namespace mixity::explorer {

/// A Wording (base/message.h). Missing constants and given options get no words: the message is beside their fields.
std::string in_fields(const Remedy& remedy);

/// The buttons that set what a message recommends: [{"option", "value", "label", "adds": whether the value joins a
/// list, "reads": whether it tells how files are read, not how they are fitted}].
Json buttons_of(const Message& message);

}  // namespace mixity::explorer
