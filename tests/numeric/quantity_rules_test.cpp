// Which quantities may be mixed, and what becomes of them. All of it is checked by the compiler; what it must
// refuse at the call of a consteval constructor is in must_not_compile/.
#include <concepts>
#include <type_traits>

#include <gtest/gtest.h>

#include "numeric/fixed_numbers.h"
#include "numeric/float_numbers.h"

namespace vitrine {
namespace {

using Unit = FixedNumbers::Unit;
using Length = FixedNumbers::Length;
using Area = FixedNumbers::Area;
using Square = FixedNumbers::Square;
using Density = FixedNumbers::Density;

template <class A, class B>
concept Add = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Subtract = requires(A a, B b) {
  a - b;
};
template <class A, class B>
concept Multiply = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept Divide = requires(A a, B b) {
  a / b;
};
template <class A, class B>
concept Compare = requires(A a, B b) {
  a < b;
};
template <class A, class B>
concept Equal = requires(A a, B b) {
  a == b;
};

template <class A, class B>
using Product = decltype(std::declval<A>() * std::declval<B>());
template <class A, class B>
using Quotient = decltype(std::declval<A>() / std::declval<B>());

// Unit times anything keeps the other's type.
static_assert(std::same_as<Product<Unit, Unit>, Unit>);
static_assert(std::same_as<Product<Unit, Length>, Length>);
static_assert(std::same_as<Product<Length, Unit>, Length>);
static_assert(std::same_as<Product<Density, Unit>, Density>);
static_assert(std::same_as<Product<Unit, Density>, Density>);
static_assert(std::same_as<Quotient<Unit, Unit>, Unit>);
static_assert(std::same_as<Quotient<Density, Unit>, Density>);
static_assert(std::same_as<Product<Length, Length>, Area>);
static_assert(std::same_as<Quotient<Area, Area>, Unit>);
static_assert(std::same_as<decltype(square(Unit{})), Square>);
static_assert(std::same_as<decltype(dot(Vec3<Length>{}, Vec3<Length>{})), Area>);
static_assert(std::same_as<decltype(dot(Vec3<Unit>{}, Vec3<Unit>{})), Unit>);
static_assert(std::same_as<decltype(normalize(Vec3<Length>{})), Vec3<Unit>>);
static_assert(std::same_as<decltype(length(Vec3<Length>{})), Length>);
static_assert(std::same_as<Product<Vec3<Length>, Unit>, Vec3<Length>>);
static_assert(std::same_as<Product<Vec3<Unit>, Length>, Vec3<Length>>);
static_assert(std::same_as<Product<Vec3<Density>, Vec3<Unit>>, Vec3<Density>>);

// Different quantities are neither added nor compared.
static_assert(!Add<Unit, Length> && !Subtract<Unit, Length> && !Compare<Unit, Length> &&
              !Equal<Unit, Length>);
static_assert(!Add<Length, Area> && !Add<Unit, Square> && !Add<Unit, Density> && !Add<Density, Area>);
static_assert(!Compare<Area, Square> && !Compare<Density, Unit> && !Equal<Density, Length>);
static_assert(!Add<Vec3<Unit>, Vec3<Length>> && !Subtract<Vec3<Length>, Vec3<Unit>>);

// Nor multiplied where the result would be no quantity.
static_assert(!Multiply<Area, Length> && !Multiply<Area, Unit> && !Multiply<Density, Length>);
static_assert(!Divide<Unit, Length> && !Divide<Length, Length> && !Divide<Density, Area>);
static_assert(!Subtract<Density, Density>, "a Wide has no sign");

// Floating point comes in as a constant and by an explicit constructor, never silently; only `int` constants
// do.
static_assert(!std::convertible_to<double, Unit> && !std::convertible_to<float, Unit>);
static_assert(!std::convertible_to<double, Density> && !std::convertible_to<double, Length>);
static_assert(!std::convertible_to<long, Unit> && !std::convertible_to<unsigned, Unit>);
static_assert(!std::convertible_to<bool, Unit> && !std::convertible_to<char, Unit>);
static_assert(!Multiply<Unit, double> && !Multiply<float, Length> && !Add<Unit, double> &&
              !Compare<Unit, double>);

// Between quantities only explicitly.
static_assert(!std::convertible_to<Length, Unit> && std::constructible_from<Length, Unit>);
static_assert(!std::convertible_to<Unit, Density> && std::constructible_from<Density, Unit>);
static_assert(!std::convertible_to<Density, Unit> && std::constructible_from<Unit, Density>);
static_assert(!std::convertible_to<Unit, float> && !std::constructible_from<float, Unit>);
static_assert(!std::constructible_from<double, Density> && !std::constructible_from<bool, Unit>);

// Plain data, of the size that the tables of a World count on.
static_assert(std::is_trivially_copyable_v<Unit> && sizeof(Unit) == 4);
static_assert(std::is_trivially_copyable_v<Density> && sizeof(Density) == 8);
static_assert(std::is_trivially_default_constructible_v<Unit>);

// Constants read alike in both systems, and are computed by the compiler.
template <class Numbers>
constexpr bool kConstantsRead = [] {
  using U = typename Numbers::Unit;
  const U x(0.25);
  return 1 - x == U(0.75) && x > 0 && x < 1 && -x < 0;
}();
static_assert(kConstantsRead<FloatNumbers> && kConstantsRead<FixedNumbers>);

TEST(QuantityRulesTest, HoldAsThisFileCompiles) { SUCCEED(); }

}  // namespace
}  // namespace vitrine
