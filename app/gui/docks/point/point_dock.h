#pragma once

#include <QWidget>

#include "core/io/files/check_output.h"

class QLabel;
class QPushButton;
class QScrollArea;

namespace noonmark {

class PointInspector;
class SkyPicture;

/// The sun and sky of the clicked point: a sentence, figures, the skyline with the sun's paths, and buttons
/// that save them.
class PointDock final : public QWidget {
    Q_OBJECT
public:
    /// `inspector` must outlive this object.
    explicit PointDock(PointInspector& inspector, QWidget* parent = nullptr);

    /// Writes the drawing (.svg, .png) or the minutes by month and hour (.csv).
    Result<void> save(const QString& file, const OutputRules& rules);

Q_SIGNALS:
    void saveRequested();

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    QWidget* makeSide();
    void showAnswer();
    void showError(const Error& error);

    PointInspector& inspector_;
    QLabel* sentence_;
    QLabel* figures_;
    QPushButton* save_;
    SkyPicture* picture_;
    QScrollArea* scroll_;
};

}  // namespace noonmark
