#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/window/massing/live_follower.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark {

struct OpenCity;
class ViewPanel;

/// Shows what edits would make of the city before they are made: what goes is gone, what comes stands there
/// in another colour, and its shadow follows. The city's own arrays stay as they are.
class EditPreview final : public QObject {
    Q_OBJECT
public:
    /// `panel` outlives it.
    EditPreview(ViewPanel& panel, std::shared_ptr<SharedHorizonCache> horizons, QObject* parent = nullptr);

    void setCity(std::shared_ptr<const OpenCity> city);  ///< ends the preview
    void setQuestion(const LiveQuestion& question);

    /// In place of the edits before. Error: they cannot be applied; nothing changes then.
    Result<void> show(const std::vector<Edit>& edits);
    void clear();
    [[nodiscard]] bool shown() const { return shown_; }
    /// What is there by the edits that are shown.
    [[nodiscard]] const CityChanges& changes() const { return changes_; }
    [[nodiscard]] const LiveFollower& live() const { return live_; }
    [[nodiscard]] JobSlot& working() { return live_.working(); }  ///< on the live shadow

Q_SIGNALS:
    void told(QString text);  ///< why there is no live shadow
    void shownChanged(bool shown);

private:
    void hide(const std::vector<std::shared_ptr<const Building>>& removed);
    void begin();
    void showLive();
    void tellAge();
    void tellWhy(const Error& error);

    ViewPanel& panel_;
    std::shared_ptr<const OpenCity> city_;
    CityChanges changes_;
    bool shown_ = false;
    LiveQuestion question_;
    LiveFollower live_;
};

}  // namespace noonmark
