#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/base/jobs/job.h"
#include "core/base/result.h"
#include "core/engines/ray/ray_scene.h"
#include "render/scene/city_arrays.h"

namespace noonmark {

class ViewPanel;
class Workbench;

/// The scenario that the view compares the displayed one with. Its city is prepared in a job and shown as
/// CityView::other(); it is prepared again when the view gets other arrays.
class OtherScenario final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    OtherScenario(Workbench& workbench, ViewPanel& panel, QObject* parent = nullptr);

    /// Shows a scenario, or existingCity, as it is now. changed() or failed() follows, at once if it is shown
    /// already.
    void show(const std::string& scenario);
    void clear();  ///< shows none, and frees its city

    [[nodiscard]] const std::string& name() const { return name_; }           ///< empty: none
    [[nodiscard]] std::shared_ptr<const City> city() const { return city_; }  ///< null: not shown yet
    [[nodiscard]] JobSlot& preparing() { return preparing_; }

Q_SIGNALS:
    void changed();  ///< city() is shown
    /// None is shown: the scenario is gone, memory ran out, or cancelled().
    void failed(noonmark::Error error);

private:
    struct Prepared {
        ArrayDifference changes;
        std::optional<RayScene> scene;  ///< where the processor draws
    };
    static Result<Prepared> prepare(const City& city, const CityArrays& arrays, const std::stop_token& stop);
    void start();
    void take(std::shared_ptr<const City> city, Result<Prepared> prepared);

    Workbench& workbench_;
    ViewPanel& panel_;
    std::string name_;
    std::shared_ptr<const City> city_;
    JobSlot preparing_;
};

}  // namespace noonmark
