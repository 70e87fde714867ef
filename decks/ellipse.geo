// Quarter of an elliptic plate with an elliptic hole (NAFEMS LE1, LE10): hole
// (x/ai)^2 + (y/bi)^2 = 1, edge (x/ao)^2 + (y/bo)^2 = 1. Mapped quads, finer towards the hole and its
// two ends: the last of nr elements across is `grade` times the first, the middle one of nt along
// 1/`bump` times. A thickness of H > 0 makes a plate of bricks, 0 <= z <= H, in eight layers, thin
// ones at the faces.
SetFactory("OpenCASCADE");
DefineConstant[ ai = 2, bi = 1, ao = 3.25, bo = 2.75, H = 0,
                nr = 32, nt = 64, grade = 16, bump = 0.2 ];
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(1) = {0, 0, 0};
Point(2) = {ai, 0, 0};
Point(3) = {0, bi, 0};
Point(4) = {0, bo, 0};
Point(5) = {ao, 0, 0};
Ellipse(1) = {2, 1, 2, 3};
Line(2) = {3, 4};
Ellipse(3) = {5, 1, 5, 4};
Line(4) = {2, 5};
Curve Loop(1) = {4, 3, -2, -1};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = nt + 1 Using Bump bump;
Transfinite Curve{2, 4} = nr + 1 Using Progression grade^(1 / (nr - 1));
Transfinite Surface{1} = {2, 5, 4, 3};
Recombine Surface{1};

If (H == 0)
  Physical Surface("BODY") = {1};
  Physical Curve("HOLE") = {1};
  Physical Curve("XMIN") = {2};
  Physical Curve("EDGE") = {3};
  Physical Curve("YMIN") = {4};
Else
  solid[] = Extrude{0, 0, H}{ Surface{1};
    Layers{{1, 1, 1, 1, 1, 1, 1, 1}, {0.05, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1}}; Recombine; };
  Physical Volume("BODY") = {solid[1]};
  Physical Surface("TOP") = {solid[0]};
  Physical Surface("YMIN") = {solid[2]};
  Physical Surface("EDGE") = {solid[3]};
  Physical Surface("XMIN") = {solid[4]};
  Physical Surface("HOLE") = {solid[5]};
EndIf
