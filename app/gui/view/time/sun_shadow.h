#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "core/engines/accrual/sun_depth_map.h"

namespace noonmark {

/// What the shadow of one moment is drawn for.
struct SunView {
    glm::dvec3 towardsSun{0, 0, 1};  ///< above the horizon
    LitSpace space;
    int size = 1024;  ///< texels a side of the map
};

/// Draws the map of a moment's shadow in jobs, one at a time; of the views that arrive meanwhile the newest
/// is next. The faces of the city are prepared once.
class SunShadow final : public QObject {
    Q_OBJECT
public:
    explicit SunShadow(QObject* parent = nullptr) : QObject(parent) {}

    void setCity(std::shared_ptr<const City> city);
    void look(const std::optional<SunView>& view);  ///< none: no map

    /// Of the newest view that is drawn; null: none, or none yet.
    [[nodiscard]] std::shared_ptr<const SunDepthMap> map() const { return map_; }
    [[nodiscard]] bool busy() const { return slot_.busy(); }

Q_SIGNALS:
    void changed();

private:
    struct Drawn {
        std::shared_ptr<const CasterFaces> faces;
        std::shared_ptr<const SunDepthMap> map;
    };
    void ask();
    void take(const Result<Drawn>& drawn);

    std::shared_ptr<const City> city_;
    std::shared_ptr<const CasterFaces> faces_;  // of city_; null: not prepared yet
    std::optional<SunView> view_;
    bool waiting_ = false;  // view_ has changed since the running job began
    std::shared_ptr<const SunDepthMap> map_;
    JobSlot slot_;
};

}  // namespace noonmark
