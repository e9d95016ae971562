#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/tools/live/live_change.h"
#include "app/gui/tools/live/live_effects.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark {

/// What an edit changes, a few lines for beside the cursor: area of new shadow over the thresholds, minutes
/// at the worst spot, the places with most new shadow, and `verdicts` (empty: none) in the last line.
QString describeEffect(const LiveChange& change, const QString& verdicts);

struct GroundAnswer;
struct OpenCity;
class ViewPanel;

/// Shows the effect of edits before they are made: removed buildings are hidden, added ones are shown in
/// another colour with their live shadow. The arrays of the city are not changed.
class EditPreview final : public QObject {
    Q_OBJECT
public:
    /// `panel` must outlive it.
    EditPreview(ViewPanel& panel, std::shared_ptr<SharedHorizonCache> horizons, QObject* parent = nullptr);

    void setCity(std::shared_ptr<const OpenCity> city);  ///< ends the preview
    void setQuestion(const LiveQuestion& question);
    [[nodiscard]] const Region& region() const { return question_.region; }  ///< of the study
    [[nodiscard]] const std::vector<Place>& places() const { return question_.places; }
    /// The city that edits are compared with, and its scenario's name; null: none.
    void setBaseline(std::shared_ptr<const City> city, const std::string& scenario);
    /// Shows the change against the baseline instead of the shadow, without facades; at first it does not.
    void showChange(bool shown);
    /// The verdicts on what is shown, for describeEffect(); empty: none.
    void setVerdicts(const QString& words);
    void setFacades(const FacadeSettings& facades);  ///< bays and storeys of the live facades
    void showFacades(bool shown);                    ///< the sunlight of the added buildings' facades
    /// Shows the facades of another building of the city too, or no longer; until the preview ends.
    void toggleNeighbour(const std::shared_ptr<const Building>& building);

    /// Replaces the edits shown before. Error: the edits cannot be applied; then nothing changes.
    Result<void> show(const std::vector<Edit>& edits);
    void clear();
    [[nodiscard]] bool shown() const { return shown_; }
    /// The buildings removed and added by the edits shown.
    [[nodiscard]] const CityChanges& changes() const { return changes_; }
    [[nodiscard]] const LiveFollower& live() const { return live_; }
    [[nodiscard]] const LiveFacades& facades() const { return facades_; }
    [[nodiscard]] JobSlot& working() { return live_.working(); }              ///< jobs of the live shadow
    [[nodiscard]] JobSlot& measuringFacades() { return facades_.working(); }  ///< jobs of the live facades

Q_SIGNALS:
    /// What the edits change, in the words of describeEffect(); empty: not known yet, or no longer shown.
    void effectChanged(QString words);
    void effectAged();          ///< the words are of an earlier shape for half a second or more
    void hinted(QString text);  ///< the reason why there is no live shadow
    void shownChanged(bool shown);
    /// The city with the edits shown; null: they are no longer shown.
    void shapeChanged(std::shared_ptr<const noonmark::City> proposed);

private:
    void hide(const std::vector<std::shared_ptr<const Building>>& removed);
    void begin();
    void beginFacades();
    void followFacades();
    void showLiveFacades();
    void showLive();
    void showEffect();
    [[nodiscard]] bool showsChange() const;
    [[nodiscard]] GroundAnswer makeLiveAnswer() const;
    void showAge();
    void showReason(const Error& error);

    ViewPanel& panel_;
    std::shared_ptr<const OpenCity> city_;
    CityChanges changes_;
    bool shown_ = false;
    LiveQuestion question_;
    std::shared_ptr<const City> baseline_;
    std::string baselineName_;
    bool changeShown_ = false;
    QString verdicts_;
    LiveFollower live_;
    LiveFacades facades_;
    FacadeSettings facadeSettings_;
    OwnStoreys storeys_;  // of the shown shape
    bool facadesShown_ = true;
    std::vector<std::shared_ptr<const Building>> neighbours_;
};

}  // namespace noonmark
