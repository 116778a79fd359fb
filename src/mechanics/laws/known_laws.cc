#include "mechanics/laws/known_laws.h"

#include <mutex>

#include "base/number_text.h"

namespace mixity {
namespace {

struct KnownLaws {
  std::mutex one_at_a_time;
  std::vector<std::shared_ptr<const ExpressionLaw>> laws;
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

/// What a law that is known has otherwise than another one of its key, as what follows that.
std::string difference(const ExpressionLaw& known, const ExpressionLaw& given) {
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

std::shared_ptr<const ExpressionLaw> add_law(const std::shared_ptr<const ExpressionLaw>& made, LawError& error) {
  const std::lock_guard lock(known_laws().one_at_a_time);
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

std::shared_ptr<const ExpressionLaw> define_law(const LawDefinition& definition, LawError& error) {
  const std::shared_ptr<const ExpressionLaw> made = ExpressionLaw::make(definition, error);
  return made ? add_law(made, error) : made;
}

std::shared_ptr<const ExpressionLaw> find_law(std::string_view key) {
  const std::lock_guard lock(known_laws().one_at_a_time);
  for (const auto& law : known_laws().laws)
    if (law->definition().key == key) return law;
  return nullptr;
}

std::vector<std::string> law_keys() {
  const std::lock_guard lock(known_laws().one_at_a_time);
  std::vector<std::string> keys;
  for (const auto& law : known_laws().laws) keys.push_back(law->definition().key);
  return keys;
}

void forget_law(std::string_view key) {
  std::vector<std::shared_ptr<const ExpressionLaw>> forgotten;  // freed after the lock, as a function may call back
  const std::lock_guard lock(known_laws().one_at_a_time);
  std::vector<std::shared_ptr<const ExpressionLaw>>& laws = known_laws().laws;
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const auto& law) { return law->definition().key == key; });
  if (found == laws.end()) return;
  forgotten.push_back(std::move(*found));
  laws.erase(found);
}

void forget_laws() {
  std::vector<std::shared_ptr<const ExpressionLaw>> forgotten;
  const std::lock_guard lock(known_laws().one_at_a_time);
  forgotten.swap(known_laws().laws);
}

}  // namespace mixity
