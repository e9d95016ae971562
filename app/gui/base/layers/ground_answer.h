#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <variant>

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"
#include "app/report/maps/shadow_measure.h"
#include "core/engines/api/shadow_field.h"
#include "core/measures/colour_scale.h"
#include "core/measures/shown_quantity.h"
#include "core/study/elements/element_study.h"
#include "render/scene/ground_picture.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The score as a picture for the ground, transparent where there is no receiver, and where it is 0.
/// O(cells).
GroundPicture scorePicture(const Score& score, const ColourScale& scale);

/// "score +0.520 m² a m²" of the cell that contains a point; empty outside the grid.
QString formatScore(const Score& score, glm::dvec2 point);

/// The measured error of what a map shows, beside its legend, so that nobody takes an approximate map for an
/// exact one. Empty if it was not measured.
QString describeError(const std::optional<SampledError>& error, ShadowMeasure measure);
/// The error of a cell in the unit shown, in the mean and for 99 of 100 cells.
QString describeCellError(const SampledError& error, double sunlitMin, ShownAs show);
QString describeError(const ElementStudy& study, ShadowMeasure measure);

/// Any result displayed on the ground, ready to be coloured and described. A value; it shares the result's
/// data.
struct GroundAnswer {
    using Map = std::variant<std::shared_ptr<const ShadowField>, std::shared_ptr<const Impact>,
                             std::shared_ptr<const Score>>;
    /// The same answer with trees of one column, evergreen or seasonal.
    struct Column {
        TreeColumns column;
        Map map;  ///< not null
        bool grossOnly;
    };
    Map map;  ///< not null
    /// The receivers of the field, if known: then cells under buildings get colours too.
    std::shared_ptr<const Receivers> receivers;
    QString note;            ///< describes the result, beside the legend, after `when`
    bool marked = false;     ///< the note is a warning
    bool grossOnly = false;  ///< no continuous shadow: gross is shown for both measures
    /// Added to the note if gross is shown instead of continuous.
    QString whyGross{};
    /// Instead of the note while continuous shadow is shown; empty: the note holds for both measures.
    QString runNote{};
    /// Error of gross shadow, stated in the unit shown before the note; none: not measured.
    std::optional<SampledError> error{};
    QString when{};  ///< the period that the minutes are of (describeWhen()); empty: not known
    std::vector<Column> withTrees{};           ///< where trees reach a receiver, evergreens first
    TreeColumns trees = TreeColumns::without;  ///< the column of `map`
};

/// Each shares the data of the answer that it is made from.
GroundAnswer makeGroundAnswer(const std::shared_ptr<const Study>& study);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const PartialField>& partial);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const ImpactAnswer>& comparison);
/// One of its two scenarios. `field`: of its study.
GroundAnswer makeGroundAnswer(const std::shared_ptr<const ImpactAnswer>& comparison,
                              const ShadowField& field);
GroundAnswer makeGroundAnswer(const std::shared_ptr<const ScoreAnswer>& score);
/// A field alone. `owner` keeps it alive.
GroundAnswer makeGroundAnswer(std::shared_ptr<const void> owner, const ShadowField& field);

/// The answer as shown in a column of trees; as it is where it was not measured so. Its error is that without
/// trees, and the note says so.
GroundAnswer showColumn(GroundAnswer answer, TreeColumns column);

/// Sets grossOnly and whyGross according to the map: of a study, a comparison or a saved result without
/// continuous shadow.
GroundAnswer markMissingRuns(GroundAnswer answer);

/// The note, with the error of what is shown and the reason if the measure is not the one shown.
QString makeNote(const GroundAnswer& answer, ShadowMeasure measure, ShownAs show = ShownAs::shadow);

/// A score is the same for both measures. `scale`: of a difference.
Legend makeLegend(const GroundAnswer& answer, ShadowMeasure measure, const ChangeScale& scale,
                  const LegendChoice& choice = {});
/// The picture in the colours of such a legend, of this answer or of another.
GroundPicture makePicture(const GroundAnswer& answer, ShadowMeasure measure, const Legend& legend);

/// The picture of receivers on roofs; nothing if there are none, or if receivers are not known.
std::optional<GroundPicture> roofPictureOf(const GroundAnswer& answer, ShadowMeasure measure,
                                           const Legend& legend);

/// Whether the point is at a receiver on a roof; then textAt() describes it.
bool isOnRoof(const GroundAnswer& answer, glm::dvec2 point);

/// Describes the cell that contains a point, by its shadow or its sun; empty outside.
QString textAt(const GroundAnswer& answer, glm::dvec2 point, ShownAs show = ShownAs::shadow);

}  // namespace noonmark
