#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"
#include "app/window/massing/live_shadow.h"
#include "app/window/time/time_looking.h"
#include "core/engines/api/partial_field.h"
#include "render/scene/ground_picture.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// A result that lies on the ground, whatever it measures. A value; what it shows is shared.
struct GroundAnswer {
    using Map = std::variant<std::shared_ptr<const ShadowField>, std::shared_ptr<const Impact>,
                             std::shared_ptr<const Score>>;
    Map map;  ///< not null
    /// Of a field, where they are known: then cells under buildings have colours too.
    std::shared_ptr<const Receivers> receivers;
    QString note;            ///< what it is, beside the legend
    bool marked = false;     ///< the note is a warning
    bool grossOnly = false;  ///< no longest runs were counted: gross stands for both measures
    QString whyGross{};      ///< said beside the note where it stands for continuous
};

/// Each shares the answer it is made from.
GroundAnswer makeGroundAnswer(const std::shared_ptr<const Study>& study);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const PartialField>& partial);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const TimeAnswer>& time);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const LiveAnswer>& live);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const ImpactAnswer>& comparison);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const ScoreAnswer>& score);

/// With grossOnly and whyGross as its map asks for: a study, an impact or a kept result without runs.
GroundAnswer runsLookedFor(GroundAnswer answer);

/// The note, and why the measure is not what is shown.
QString makeNote(const GroundAnswer& answer, ShadowMeasure measure);

/// A score has no measure: it is the same for both. `scale`: of a difference.
Legend makeLegend(const GroundAnswer& answer, ShadowMeasure measure, const ChangeScale& scale);
GroundPicture makePicture(const GroundAnswer& answer, ShadowMeasure measure, double top);

/// Of receivers on roofs; nothing where there are none, or they are not known.
std::optional<GroundPicture> roofPictureOf(const GroundAnswer& answer, ShadowMeasure measure, double top);

/// Whether a receiver on a roof is there: then textAt() tells of it.
bool isOnRoof(const GroundAnswer& answer, glm::dvec2 point);

/// What the cell holds that a point lies in, in words; empty outside.
QString textAt(const GroundAnswer& answer, glm::dvec2 point);

}  // namespace noonmark
