#include "mechanics/laws/known_laws.h"

#include <mutex>

#include "base/number_text.h"

namespace mixity {
namespace {

struct KnownLaws {
  std::mutex mutex;
  std::vector<std::shared_ptr<const UserLaw>> laws;
};

KnownLaws& known_laws() {
  static KnownLaws all;
  return all;
}

std::string range_of(const LawParameter& one) {
  std::string text;
  for (const double number : {one.lower, one.upper, one.start}) {
    text += text.empty() ? "" : text.find("..") == std::string::npos ? ".." : " start ";
    text += shortest(number);
  }
  return text;
}

/// The known law, and its difference from another one with the same key.
std::string difference(const UserLaw& known, const UserLaw& given) {
  const LawDefinition &one = known.definition(), &other = given.definition();
  if (one.text != other.text || one.normalised != other.normalised)
    return known.shown() + (one.normalised == other.normalised ? ""
                            : one.normalised                   ? ", normalised"
                                                               : ", not normalised");
  if (one.sampler != other.sampler) return known.shown() + ", another function";
  if (one.parameters.size() != other.parameters.size())
    return known.shown() + ", of " + std::to_string(one.parameters.size()) + " parameters";
  for (std::size_t i = 0; i < one.parameters.size(); ++i) {
    const LawParameter &a = one.parameters[i], &b = other.parameters[i];
    if (a.name != b.name) return known.shown() + ", whose parameter " + std::to_string(i + 1) + " is " + a.name;
    if (a.lower != b.lower || a.upper != b.upper || a.start != b.start)
      return known.shown() + ", whose " + a.name + " is in " + range_of(a) + ", not in " + range_of(b);
  }
  return "";
}
}  // namespace

std::shared_ptr<const UserLaw> add_law(const std::shared_ptr<const UserLaw>& made, LawError& error) {
  const std::lock_guard lock(known_laws().mutex);
  for (const auto& other : known_laws().laws) {
    if (other->definition().key != made->definition().key) continue;
    if (same_law(other->definition(), made->definition())) return other;
    error = {{},
             "there is another law '" + made->definition().key + "': " + difference(*other, *made) +
                 "; choose another key for this one"};
    return nullptr;
  }
  known_laws().laws.push_back(made);
  return made;
}

std::shared_ptr<const UserLaw> define_law(const LawDefinition& definition, LawError& error) {
  const std::shared_ptr<const UserLaw> made = UserLaw::make(definition, error);
  return made ? add_law(made, error) : made;
}

std::shared_ptr<const UserLaw> find_law(std::string_view key) {
  const std::lock_guard lock(known_laws().mutex);
  for (const auto& law : known_laws().laws)
    if (law->definition().key == key) return law;
  return nullptr;
}

std::vector<std::string> law_keys() {
  const std::lock_guard lock(known_laws().mutex);
  std::vector<std::string> keys;
  for (const auto& law : known_laws().laws) keys.push_back(law->definition().key);
  return keys;
}

void forget_laws() {
  std::vector<std::shared_ptr<const UserLaw>> forgotten;  // freed after the lock, as a function may call back
  const std::lock_guard lock(known_laws().mutex);
  forgotten.swap(known_laws().laws);
}

}  // namespace mixity
