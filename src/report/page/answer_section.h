// The first screen of a data set: its result.
#pragma once

#include <functional>
#include <pugixml.hpp>

#include "analysis/answer.h"

namespace mixity {

/// `add_figure` draws the figure that belongs to it into a node.
void add_answer(pugi::xml_node section, const Answer& answer, const Dataset& data,
                const std::function<void(pugi::xml_node)>& add_figure);

}  // namespace mixity
