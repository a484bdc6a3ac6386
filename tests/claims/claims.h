// What the lecture claims: one way of sampling beats another on a scene. The claims are a table; how they are
// measured stands below it. claims_test.cpp holds them at equal samples, lecture_claims.cpp prints them at
// equal samples and at equal time.
#pragma once

#include <string_view>
#include <vector>

namespace vitrine {

struct Claim {
  std::string_view section;
  std::string_view scene;
  std::string_view better;  ///< a technique, as the command line writes it
  std::string_view worse;
  double at_most = 1.0;            ///< times the worse one's variance
  std::string_view material = "";  ///< only where the eye sees it; empty: the whole picture
};

inline const std::vector<Claim>& claims() {
  static const std::vector<Claim> all{
      {"Next event estimation", "cornell", "nee", "basic"},
      {"Next event estimation", "plates", "nee-tree", "basic"},
      {"Next event estimation", "lamps", "nee-tree", "basic"},
      {"4 shadow rays, direct light", "cornell", "nee shadow-rays=4 roulette=fixed-depth:1",
       "nee roulette=fixed-depth:1", 1.0, "red"},
      {"16 shadow rays, direct light", "cornell", "nee shadow-rays=16 roulette=fixed-depth:1",
       "nee shadow-rays=4 roulette=fixed-depth:1", 1.0, "red"},
      {"256 shadow rays, direct light", "cornell", "nee shadow-rays=256 roulette=fixed-depth:1",
       "nee shadow-rays=16 roulette=fixed-depth:1", 1.0, "red"},
      {"Cosine distribution", "cornell", "basic-cosine", "basic"},
      {"Cosine distribution", "cornell", "nee", "nee directions=uniform"},
      {"BRDF*cosine on glossy", "plates", "basic-brdf-cosine", "basic-cosine"},
      {"BRDF*cosine on glossy", "gallery", "mis", "mis directions=cosine"},
      {"Split over all lights", "lamps", "nee-all", "nee"},
      {"Lights by power", "lamps", "nee-power", "nee"},
      {"Light tree", "lamps", "nee-tree", "nee-power"},
      {"Solid angle", "cornell", "nee light-points=solid-angle", "nee"},
      {"MIS, plate 1", "plates", "mis", "nee-tree", 1.1, "steel, alpha 0.005"},
      {"MIS, plate 1", "plates", "mis", "basic-brdf-cosine", 1.1, "steel, alpha 0.005"},
      {"MIS, plate 2", "plates", "mis", "nee-tree", 1.1, "steel, alpha 0.02"},
      {"MIS, plate 2", "plates", "mis", "basic-brdf-cosine", 1.1, "steel, alpha 0.02"},
      {"MIS, plate 3", "plates", "mis", "nee-tree", 1.1, "steel, alpha 0.05"},
      {"MIS, plate 3", "plates", "mis", "basic-brdf-cosine", 1.1, "steel, alpha 0.05"},
      {"MIS, plate 4", "plates", "mis", "nee-tree", 1.1, "steel, alpha 0.1"},
      {"MIS, plate 4", "plates", "mis", "basic-brdf-cosine", 1.1, "steel, alpha 0.1"},
      {"MIS with a light tree", "lamps", "mis", "mis lights=uniform"},
      {"Stratified samples", "cornell", "mis sequence=stratified", "mis"},
      {"Sobol samples", "cornell", "mis sequence=sobol", "mis"},
      {"Blue-noise samples", "cornell", "mis sequence=blue-noise", "mis"},
      {"Small alpha: short paths", "cornell", "mis", "mis roulette=constant:0.1"},
  };
  return all;
}

}  // namespace vitrine
