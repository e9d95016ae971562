#pragma once

#include <QImage>

#include "app/report/book/book.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// Sheets of sun by place: the finding in a sentence, error and method; a map of the places coloured by hours
/// of sun; a table of the places, those with the largest loss first or, without scenarios, those with least
/// sun. Tables list so many rows at most; the heading names the file with the others.
Book makeSunByPlaceBook(const SunOfCities& sun, const BookSettings& settings,
                        const PlaceColours& colours = {});
/// Its map alone, with legend, scale bar and north: of the smallest box that holds the places. `city`: the
/// buildings around them.
QImage paintPlacesMap(const SunByPlace& sun, const City& city, const PlaceColours& colours, int widthPx);
/// The options of a command that draw it in these colours.
std::vector<CommandOption> listColourOptions(const PlaceColours& colours);
inline constexpr std::size_t maxRowsOfPlaces = 150;

}  // namespace noonmark
