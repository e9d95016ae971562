#include "core/sun/zone_country.h"

#ifdef NOONMARK_HAS_GEONAMES
#include <geonames.h>
#endif

namespace noonmark {

#ifdef NOONMARK_HAS_GEONAMES

namespace {

std::string textOrNothing(const char* text) { return text == nullptr ? std::string() : text; }

}  // namespace

std::vector<Town> listTowns() {
    std::vector<Town> towns;
    const int count = geonames_get_n_cities();
    towns.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i) {
        GeonamesCity* city = geonames_get_city(i);
        if (city == nullptr) continue;
        towns.push_back({{geonames_city_get_longitude(city), geonames_city_get_latitude(city)},
                         textOrNothing(geonames_city_get_name(city)),
                         textOrNothing(geonames_city_get_country_code(city)),
                         textOrNothing(geonames_city_get_timezone(city))});
        geonames_city_free(city);
    }
    return towns;
}

#else

std::vector<Town> listTowns() { return {}; }

#endif

}  // namespace noonmark
