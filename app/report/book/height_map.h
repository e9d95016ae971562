#pragma once

#include "app/report/book/book.h"
#include "core/city/city.h"

namespace noonmark {

/// A page with a map of the city's buildings in the colours of where their heights come from, and a legend
/// that counts them. `shown`: the part of the ground, local metres; empty: all buildings. The page owns what
/// it shows.
BookPage makeHeightMapPage(const City& city, const Box2& shown, const PageSetup& setup);

}  // namespace noonmark
