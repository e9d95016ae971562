#pragma once

#include <functional>
#include <memory>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/project/view_mode.h"
#include "app/gui/view/exploration/view_refinement.h"
#include "app/gui/view/panel/legend_strip.h"
#include "app/gui/view/time/moment_preview.h"
#include "render/view/city_view.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// Cells of two scenarios that are compared in the view, in one set of colours; none: not measured.
struct ComparedSides {
    struct Side {
        std::string scenario;
        std::optional<GroundAnswer> ground;
    };
    Side displayed, other;
};

/// The result on the surfaces of the view, with its legend: the explored view, a study, another result
/// displayed instead of it, or the partial result of a running study, which is marked as such. Results stay
/// stored while another mode is shown.
class ResultLayer {
public:
    ResultLayer(CityView& view, LegendStrip& legend);  ///< both must outlive it

    void forget();  ///< another city
    void setMode(ViewMode mode);
    /// The displayed answer; none: no answer. Ends a partial one. `isStudy`: of cells in one scenario, so
    /// that days and moments of it can be shown instead (setTime).
    void setAnswer(std::optional<AnswerLayer> answer, bool isStudy = false);
    /// The element that the view shows at a place of the scene, as the camera sees it.
    [[nodiscard]] std::optional<std::size_t> elementAt(const glm::dvec3& place) const;
    /// Tiles displayed instead of the result of any mode, but for a live shadow and a moment; none: shows
    /// that again. They stay when the city changes.
    void setTiles(std::shared_ptr<const TileView> tiles);
    /// Another note beside the legend, while the tiles are shown.
    void noteTiles(const QString& note, bool marked);
    /// One of setTiles() at a place of the scene, as the camera sees it.
    [[nodiscard]] std::optional<std::size_t> tileAt(const glm::dvec3& place) const;
    /// Places in colours, displayed instead of the ground of the displayed answer; null: none.
    void setPlaces(std::shared_ptr<const PlaceView> places);
    /// Places in the colours of their verdicts, displayed in the mode Review; null: none.
    void setVerdicts(std::shared_ptr<const PlaceView> verdicts);
    [[nodiscard]] bool showsVerdicts() const;
    [[nodiscard]] const PlaceView* shownVerdicts() const {
        return showsVerdicts() ? verdicts_.get() : nullptr;
    }
    [[nodiscard]] bool showsElements() const;
    [[nodiscard]] bool showsTiles() const;
    [[nodiscard]] bool showsPlaces() const;
    /// The threshold of the colours of places; none: no places are shown.
    [[nodiscard]] std::optional<double> thresholdHours() const {
        return showsPlaces() ? std::optional(places_->thresholdHours) : std::nullopt;
    }
    /// Those of setPlaces().
    [[nodiscard]] const PlaceView* places() const { return places_.get(); }
    /// Partial result of a running study, displayed instead of the one before; null: none, shows the one
    /// before again.
    void setPartial(std::shared_ptr<const PartialField> partial);
    /// A day or moment of the study, displayed instead of it; null: none, shows the study again.
    void setTime(const std::shared_ptr<const TimeAnswer>& answer);
    /// Sun and shadow of a moment are shown, in these words: only a study's cells of that moment are shown
    /// with them, and tiles unless it covers them. Empty: no moment is shown.
    void setMoment(const QString& words, bool coversTiles = true);
    void setExplored(std::shared_ptr<const ViewAnswer> answer);  ///< null: none

    /// The live shadow, displayed in any mode until it is none.
    void setLive(std::optional<GroundAnswer> answer);
    /// The sunlight of facades in the colours of the live shadow, until it is none.
    void setLiveFacades(std::optional<ElementView> facades);
    /// Replaces the live shadow's note, as a warning. Does nothing without a live shadow.
    void noteLive(const QString& note);

    /// While two scenarios are compared in the view: what is shown of each instead of the displayed answer's
    /// ground; none: nothing is compared. Places are those of their names.
    void setSides(std::optional<ComparedSides> sides);
    /// Names of the compared scenarios of which there is nothing to show beside the other.
    [[nodiscard]] std::vector<std::string> missingSides() const;

    /// Whether surfaces show what was explored.
    [[nodiscard]] bool showsExplored() const;
    /// Whether cells of the ground show the displayed answer, or what setSides() puts in its place.
    [[nodiscard]] bool showsAnswer() const;
    /// Called after something else is shown.
    void whenShown(std::function<void()> called) { whenShown_ = std::move(called); }

    void show();  ///< again, for instance after the measure has changed

    /// Text; empty if not known. `ofOther`: on the side of the other scenario.
    [[nodiscard]] QString minutesAt(const Pick& pick, bool ofOther = false) const;

private:
    void showCurrent();
    void showExplored();
    void showGround();
    void showElements();
    void showTiles();
    void showPlaces(const PlaceView& places);
    void showPlacesOfSides();
    [[nodiscard]] std::optional<GroundAnswer> otherGround() const;
    [[nodiscard]] QString minutesOfOther(const Pick& pick) const;
    [[nodiscard]] QString placeTextAt(const glm::dvec2& place, bool ofOther) const;
    [[nodiscard]] std::optional<std::size_t> paintedTileAt(const glm::dvec3& place) const;
    void showFacades();
    [[nodiscard]] const ElementMap* shownElements() const;
    [[nodiscard]] std::optional<GroundAnswer> ground() const;
    [[nodiscard]] GroundAnswer inChosenColumn(const GroundAnswer& answer) const;
    void showNothing();
    void showMoment();

    std::function<void()> whenShown_;
    CityView& view_;
    LegendStrip& strip_;
    ViewMode mode_ = ViewMode::exploration;
    std::optional<GroundAnswer> study_;
    std::optional<GroundAnswer> inFront_;
    std::optional<ElementView> elements_;
    std::shared_ptr<const TileView> tiles_, painted_;  ///< to be shown, and in the view
    std::shared_ptr<const PlaceView> places_;
    std::shared_ptr<const PlaceView> verdicts_;
    QString tileNote_;
    bool tileNoteMarked_ = false;
    std::optional<GroundAnswer> partial_;
    std::optional<GroundAnswer> time_;
    std::optional<GroundAnswer> live_;
    std::optional<ElementView> facades_;  ///< with live_
    std::optional<ComparedSides> sides_;
    QString moment_;
    bool momentCovers_ = true;  ///< tiles, too
    std::shared_ptr<const ViewAnswer> explored_;
};

}  // namespace noonmark
