// Solvers of another process in turn with a program's own. With --turns it prints its cases first, a line of JSON each,
// and before each repetition the line "turn", after which it waits for a line. tools/peers/turns.py is the other side.
#pragma once

#include <cstdio>
#include <functional>
#include <iostream>
#include <string>

namespace mixity::precision {

inline void let_others_take_turn() {
  std::printf("turn\n");
  std::fflush(stdout);
  std::string line;
  std::getline(std::cin, line);
}

/// Of a program whose only argument may be --turns; others are told what it knows.
struct TurnArguments {
  bool known, turns;

  TurnArguments(int count, char** arguments)
      : known(count == 1 || (count == 2 && arguments[1] == std::string("--turns"))), turns(known && count == 2) {
    if (!known) std::fprintf(stderr, "usage: %s [--turns]\n", arguments[0]);
  }
  /// What measure() takes.
  std::function<void()> turn() const { return turns ? let_others_take_turn : std::function<void()>{}; }
};

/// One more member of a JSON object: value_of() of each element.
template <class List, class ValueOf>
void print_array(const char* name, const List& list, const ValueOf& value_of) {
  const char* comma = "";
  std::printf(R"(, "%s": [)", name);
  for (const auto& element : list) {
    std::printf("%s%.17g", comma, value_of(element));
    comma = ", ";
  }
  std::printf("]");
}

}  // namespace mixity::precision
