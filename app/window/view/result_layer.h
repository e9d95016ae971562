#pragma once

#include <memory>

#include "app/window/view/ground_answer.h"
#include "app/window/view/view_mode.h"
#include "app/window/view/view_refinement.h"
#include "app/window/widgets/legend_strip.h"
#include "render/view/city_view.h"
#include "render/view/scene_picker.h"

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

    /// The shadow with what is being shaped, over whatever mode is on, until there is none.
    void setLive(std::optional<GroundAnswer> answer);
    void noteLive(const QString& note);  ///< in place of its own, as a warning; does nothing without it

    void show();  ///< again, as after another measure was chosen

    [[nodiscard]] QString minutesAt(const Pick& pick) const;  ///< in words; empty where nothing is known

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
    std::optional<GroundAnswer> live_;
    std::shared_ptr<const ViewAnswer> explored_;
};

}  // namespace noonmark
