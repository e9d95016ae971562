#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// The country of a time zone by the system's tz database, as ISO 3166-1 code: "FR" of "Europe/Paris". Empty
/// where the database states none, as for UTC. Reads a file of 20 kB.
std::string countryOfZone(std::string_view zone);

/// The English name of a country by the same database: "France" of "FR". The code where it states none.
std::string countryName(std::string_view code);

}  // namespace noonmark
