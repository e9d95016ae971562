#pragma once

#include <QMenu>

class QSettings;

namespace noonmark {

/// The menu of themes: as the system, light, dark. The choice is saved in the settings.
class ThemeMenu final : public QMenu {
    Q_OBJECT
public:
    explicit ThemeMenu(QSettings& settings, QWidget* parent = nullptr);  ///< `settings` must outlive it
};

}  // namespace noonmark
