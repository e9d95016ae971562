#pragma once

// The legend below the view: what is shown, as shadow or as sun, its colours, scale and north.

#include <QWidget>
#include <optional>

#include "app/report/maps/change_scale.h"
#include "app/report/maps/legend_painter.h"

class QComboBox;
class QSpinBox;
class QToolButton;

namespace noonmark {

class LegendEditor;

/// The strip below the view: choice of the measure, a switch between shadow and sun, the legend, a scale bar
/// and a compass. A click on the legend, or Enter, opens its editor. In a narrow window the legend has its
/// own row.
class LegendStrip final : public QWidget {
    Q_OBJECT
public:
    explicit LegendStrip(QWidget* parent = nullptr);

    void setLegend(std::optional<Legend> legend);  ///< none: no result yet
    void setHint(const QString& hint);             ///< shown if there is no legend
    /// A note on what is shown; `partial` marks it as incomplete. Empty: none.
    void setNote(const QString& note, bool partial);
    [[nodiscard]] const QString& note() const { return note_; }
    [[nodiscard]] const std::optional<Legend>& legend() const { return legend_; }
    void setHeading(double degrees);  ///< azimuth of the view, clockwise from north
    /// Device-independent pixels per metre in the middle of the view, for the scale bar; 0: none.
    void setScale(double pixelsPerM);
    [[nodiscard]] double pixelsPerM() const { return pixelsPerM_; }

    [[nodiscard]] ShadowMeasure measure() const;
    void setMeasure(ShadowMeasure measure);

    /// The scale of differences; its field is visible while a difference is shown.
    [[nodiscard]] const ChangeScale& changeScale() const { return changeScale_; }
    void setChangeScale(const ChangeScale& scale);

    [[nodiscard]] const LegendChoice& choice() const { return choice_; }
    void setChoice(const LegendChoice& choice);  ///< cannot be undone
    void chooseTrees(TreeColumns trees);         ///< as a user's choice
    /// How the sun by place is shown: its switch is not that of other results, since it is asked for as sun.
    [[nodiscard]] ShownAs shownOfPlaces() const { return shownOfPlaces_; }
    void setShownOfPlaces(ShownAs show);
    void edit();        ///< opens the editor of the legend
    void undoChoice();  ///< does nothing if there is none to undo

    [[nodiscard]] QRectF noteArea() const;      ///< the note's place; empty: no note
    [[nodiscard]] QRectF legendArea() const;    ///< beside the note
    [[nodiscard]] QString paintedNote() const;  ///< the note, shortened to the room available

Q_SIGNALS:
    void measureChanged();
    void changeScaleChanged();
    void choiceChanged();
    void placesShownChanged();  ///< shownOfPlaces()
    void shownChosen();         ///< the user switched between shadow and sun: choice().show, shownOfPlaces()

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] bool narrow() const;
    [[nodiscard]] QFont noteFont() const;
    [[nodiscard]] QSizeF noteRoom() const;
    void placeNote();
    void connectShown();
    [[nodiscard]] bool isOfPlaces() const;
    void checkShown();
    void choose(const LegendChoice& choice);
    void takeChoice(const LegendChoice& choice);
    void updateEditor();
    void takeKeys();
    void paintNote(const Canvas& canvas) const;
    void paintScale(const Canvas& canvas) const;

    QComboBox* measure_;
    QSpinBox* scale_;  ///< 0: fitted to each
    QToolButton* shadow_;
    QToolButton* sun_;
    LegendEditor* editor_ = nullptr;  ///< null until it is first opened
    ChangeScale changeScale_;
    LegendChoice choice_;
    ShownAs shownOfPlaces_ = ShownAs::sun;
    std::vector<LegendChoice> before_;  ///< to be undone, the latest last
    QString hint_;
    QString note_;
    bool partial_ = false;
    std::optional<Legend> legend_;
    double headingDeg_ = 0;
    double pixelsPerM_ = 0;
};

}  // namespace noonmark
