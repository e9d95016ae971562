#include "app/gui/session/study/gazetteer_cities.h"

#ifdef NOONMARK_HAS_GEONAMES
#include <geonames.h>
#endif

namespace noonmark {

#ifdef NOONMARK_HAS_GEONAMES

std::vector<ZoneCity> gazetteerCities() {
    std::vector<ZoneCity> cities;
    const int count = geonames_get_n_cities();
    cities.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i) {
        GeonamesCity* city = geonames_get_city(i);
        if (city == nullptr) continue;
        const QString zone = QString::fromUtf8(geonames_city_get_timezone(city));
        const QString country = QString::fromUtf8(geonames_city_get_country_code(city));
        const LonLat place{geonames_city_get_longitude(city), geonames_city_get_latitude(city)};
        if (!zone.isEmpty()) cities.push_back({place, country, zone});
        geonames_city_free(city);
    }
    return cities;
}

#else

std::vector<ZoneCity> gazetteerCities() { return {}; }

#endif

}  // namespace noonmark
