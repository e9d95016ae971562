#pragma once

#include <memory>

#include "app/window/ground_answer.h"
#include "app/window/legend_strip.h"
#include "app/window/view_mode.h"
#include "app/window/view_refinement.h"
#include "render/city_view.h"
#include "render/scene_picker.h"

namespace noonmark {

/// What lies on the surfaces of the view, and the legend that goes with it: what was explored, a study or
/// what stands before it, or the running result of a study, which is marked as such. Results are kept when
/// another mode is shown.
class ResultLayer {
public:
    ResultLayer(CityView& view, LegendStrip& legend);  ///< both outlive it

    void forget();  ///< another city
    void setMode(ViewMode mode);
    void setStudy(std::shared_ptr<const Study> study);  ///< null: none; a running result goes
    /// Stands before the study: a comparison, a score, a kept result. None: the study is shown again.
    void setInFront(std::optional<GroundAnswer> answer);
    /// Of a study that runs, over the one before; null: none, the one before is shown again.
    void setPartial(std::shared_ptr<const PartialField> partial);
    /// A day or moment of the study, in its place; null: none, and the study is shown again.
    void setTime(const std::shared_ptr<const TimeAnswer>& answer);
    void setExplored(std::shared_ptr<const ViewAnswer> answer);  ///< null: none

    /// Gross shadow of a building that is being shaped, over whatever mode is on, until null is given. `note`
    /// says what it is of; `receivers` outlives the call only.
    void setLive(const ShadowField* field, const Receivers* receivers, const QString& note);

    void show();  ///< again, as after another measure was chosen

    [[nodiscard]] QString minutesAt(const Pick& pick) const;  ///< in words; empty where nothing is known
    [[nodiscard]] std::optional<Legend> legend() const;       ///< for a picture to keep: says what is partial

private:
    void showExplored();
    void showGround();
    [[nodiscard]] const GroundAnswer* ground() const;
    void showNothing();

    CityView& view_;
    LegendStrip& strip_;
    ViewMode mode_ = ViewMode::exploration;
    std::optional<GroundAnswer> study_;
    std::optional<GroundAnswer> inFront_;
    std::optional<GroundAnswer> partial_;
    std::optional<GroundAnswer> time_;
    std::shared_ptr<const ViewAnswer> explored_;
    bool live_ = false;
};

}  // namespace noonmark
