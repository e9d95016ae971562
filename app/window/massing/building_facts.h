#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "core/city/city.h"

namespace noonmark {

/// What a user asks of a building that stands there.
struct BuildingFacts {
    QString title;  ///< name, or id where it has none
    QString id;
    double heightM = 0;  ///< above its ground
    QString heightSource;
    int storeys = 0;  ///< of usualStoreyM; 0: not one
    std::size_t parts = 0;
    double planM2 = 0;         ///< what touches the ground
    double grossFloorM2 = 0;   ///< at usualStoreyM a storey
    int estimatedStoreys = 0;  ///< of these, where its mesh is open
};

/// Some ms for a building of hundreds of points.
BuildingFacts collectFacts(const Building& building, const City& city);

/// The largest piece of what touches the ground, as a lot; none where nothing does.
std::optional<Footprint> lotUnder(const Building& building, const City& city);

}  // namespace noonmark
