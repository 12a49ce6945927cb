#include "chapters/notebook/sources.h"

namespace crevice {

std::string sources_table() {
    return R"(| name | author and title | address |
|---|---|---|
| X_Jun | X_Jun (MKXJun): DirectX11 With Windows SDK, chapter 32, SSAO (in Chinese); the text is of 2020, the code was rewritten in 2022 | <https://github.com/MKXJun/DirectX11-With-Windows-SDK>, `Project 19-/32 SSAO` |
| LearnOpenGL | Joey de Vries: LearnOpenGL, the chapter on SSAO; and notes on it, chapter 34, SSAO (in Chinese, 2022) | <https://github.com/JoeyDeVries/LearnOpenGL>, `src/5.advanced_lighting/9.ssao` |
| Luna | Frank Luna: Introduction to 3D Game Programming with DirectX 12, chapter 21, Ambient Occlusion (Mercury Learning and Information, 2016); and notes on it (in Chinese) | <https://github.com/d3dcoder/d3d12book>, `Chapter 21 Ambient Occlusion/Ssao` |
| SSAO explored | wickedpriest: 屏幕空间环境光屏蔽(SSAO)探秘, "Screen-space ambient occlusion explored" (blog article, in Chinese) | <https://www.cnblogs.com/wickedpriest/p/13219981.html> |
| Unity notes | UnityCrytekSponza, chapter 4.2, SSAO (notes on a Unity project, in Chinese) | <https://github.com/Graphic-researcher/UnityCrytekSponza-master2019> |
)";
}

}  // namespace crevice
