// Roots and minima of functions of one variable, to their last digits.
#pragma once

#include <type_traits>

namespace mixity {

/// Refers to a callable, which must outlive it.
template <class Signature>
class FunctionRef;
template <class Result, class... Argument>
class FunctionRef<Result(Argument...)> {
 public:
  template <class F>
  requires(!std::is_same_v<F, FunctionRef>)
      FunctionRef(const F& f)  // NOLINT(google-explicit-constructor): any callable is one
      : object_(&f), call_([](const void* object, Argument... argument) -> Result {
          return (*static_cast<const F*>(object))(argument...);
        }) {}
  Result operator()(Argument... argument) const { return call_(object_, argument...); }

 private:
  const void* object_;
  Result (*call_)(const void*, Argument...);
};

using RealFunction = FunctionRef<double(double)>;

/// The root of f between low and high, to this many bits. f must have different signs there, or be 0 at one of them.
double root_between(RealFunction f, double low, double high, int bits = 52);

/// A local minimum of f between low and high.
struct Minimum {
  double at, value;
};
Minimum minimum_between(RealFunction f, double low, double high, int bits);

/// Calls found(v, falls) for the sign changes of f on [from, last], in order, until it returns false; `falls` if f
/// changes from + to -. step(v), called after f(v), returns the distance to the next sample. A dip between two samples
/// is followed to its bottom; a pair of roots is skipped if the bottom between them is above -rounding.
void for_sign_changes(RealFunction f, double from, double last, double rounding, RealFunction step,
                      FunctionRef<bool(double v, bool falls)> found);

}  // namespace mixity
