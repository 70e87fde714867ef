// Patches of distorted solids in the unit cube. type: 1 TET4, 2 TET10, 3 PENTA6, 4 PENTAC15,
// 5 HEXE8, 6 HEXEC20, 7 HEXEC27. Bricks: MacNeal and Harder's seven, with node 13 at y = 0.286 so
// that none is folded (see patch_cube.inc). Tetrahedra: a free mesh of the same seven fields. Wedges:
// the cube in four prisms on triangles about an inner line, two layers.
DefineConstant[ type = 6 ];
Mesh.ElementOrder = (type == 1 || type == 3 || type == 5) ? 1 : 2;
Mesh.SecondOrderLinear = (type == 2);
Mesh.SecondOrderIncomplete = (type == 4 || type == 6);
x[] = {0, 1, 1, 0, 0, 1, 1, 0, 0.249, 0.826, 0.850, 0.273, 0.320, 0.677, 0.788, 0.165};
y[] = {0, 0, 1, 1, 0, 0, 1, 1, 0.342, 0.288, 0.649, 0.750, 0.286, 0.305, 0.693, 0.745};
z[] = {0, 0, 0, 0, 1, 1, 1, 1, 0.192, 0.288, 0.263, 0.230, 0.643, 0.683, 0.644, 0.702};

If (type == 3 || type == 4)
  For i In {0:7}
    Point(1 + i) = {x[i], y[i], z[i]};
  EndFor
  Point(9) = {0.35, 0.45, 0};
  Point(10) = {0.6, 0.7, 1};
  Line(20) = {9, 10};
  For i In {0:3}
    j = (i + 1) % 4;
    Line(1 + i) = {1 + i, 1 + j};
    Line(5 + i) = {5 + i, 5 + j};
    Line(9 + i) = {1 + i, 5 + i};
    Line(13 + i) = {1 + i, 9};
    Line(21 + i) = {5 + i, 10};
  EndFor
  For i In {0:3}
    j = (i + 1) % 4;
    Curve Loop(1 + i) = {1 + i, 13 + j, -(13 + i)};
    Plane Surface(1 + i) = {1 + i};
    Curve Loop(5 + i) = {5 + i, 21 + j, -(21 + i)};
    Plane Surface(5 + i) = {5 + i};
    Curve Loop(9 + i) = {1 + i, 9 + j, -(5 + i), -(9 + i)};
    Plane Surface(9 + i) = {9 + i};
    Curve Loop(13 + i) = {13 + i, 20, -(21 + i), -(9 + i)};
    Surface(13 + i) = {13 + i};
  EndFor
  For i In {0:3}
    j = (i + 1) % 4;
    Surface Loop(1 + i) = {1 + i, 5 + i, 9 + i, 13 + i, 13 + j};
    Volume(1 + i) = {1 + i};
    Transfinite Volume(1 + i) = {1 + i, 1 + j, 9, 5 + i, 5 + j, 10};
  EndFor
  Transfinite Curve{1:8, 13:16, 21:24} = 2;
  Transfinite Curve{9:12, 20} = 3;
  Transfinite Surface{:};
  Recombine Surface{9:16};
  Physical Volume("PATCH") = {1:4};
Else
  For i In {0:15}
    Point(1 + i) = {x[i], y[i], z[i], 0.4};
  EndFor
  For k In {0:1}
    For i In {0:3}
      j = (i + 1) % 4;
      Line(1 + 8 * k + i) = {1 + 8 * k + i, 1 + 8 * k + j};
      Line(5 + 8 * k + i) = {5 + 8 * k + i, 5 + 8 * k + j};
      Line(17 + 4 * k + i) = {1 + 8 * k + i, 5 + 8 * k + i};
    EndFor
  EndFor
  For i In {0:7}
    Line(25 + i) = {1 + i, 9 + i};
  EndFor
  For k In {0:1}
    Curve Loop(1 + 6 * k) = {1 + 8 * k, 2 + 8 * k, 3 + 8 * k, 4 + 8 * k};
    Curve Loop(2 + 6 * k) = {5 + 8 * k, 6 + 8 * k, 7 + 8 * k, 8 + 8 * k};
    For i In {0:3}
      j = (i + 1) % 4;
      Curve Loop(3 + 6 * k + i) =
        {1 + 8 * k + i, 17 + 4 * k + j, -(5 + 8 * k + i), -(17 + 4 * k + i)};
    EndFor
  EndFor
  For i In {0:3}
    j = (i + 1) % 4;
    Curve Loop(13 + i) = {1 + i, 25 + j, -(9 + i), -(25 + i)};
    Curve Loop(17 + i) = {5 + i, 29 + j, -(13 + i), -(29 + i)};
    Curve Loop(21 + i) = {17 + i, 29 + i, -(21 + i), -(25 + i)};
  EndFor
  For i In {1:24}
    Surface(i) = {i};
  EndFor
  Surface Loop(1) = {7:12};
  Surface Loop(2) = {1, 7, 13:16};
  Surface Loop(3) = {2, 8, 17:20};
  Volume(1) = {1};
  Volume(2) = {2};
  Volume(3) = {3};
  For i In {0:3}
    j = (i + 1) % 4;
    Surface Loop(4 + i) = {3 + i, 9 + i, 13 + i, 17 + i, 21 + i, 21 + j};
    Volume(4 + i) = {4 + i};
  EndFor
  Transfinite Curve{:} = 2;
  If (type > 4)
    Transfinite Surface{:};
    Recombine Surface{:};
    Transfinite Volume{:};
  EndIf
  Physical Volume("PATCH") = {1:7};
EndIf
