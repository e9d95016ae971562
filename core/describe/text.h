#pragma once

/// Marks a text of core that the GUI and sheets show in the user's language; the command line uses it as it
/// stands, in English (core/base/wording.h). lupdate reads the macro (app/CMakeLists.txt), in the context "noonmark".
#define NM_TEXT(text) text
