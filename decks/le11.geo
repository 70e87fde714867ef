// Solid cylinder, taper and sphere of NAFEMS LE11: meridian section, x the radius, y the axis.
//
//     H---I    1.79     inside: sphere of radius 1 from A to E (45 degrees), cylinder to H
//     |   |             outside: sphere of radius 1.4 from B to D (30 degrees), taper to G,
//     M---G    1.39              cylinder to I
//     |    :
//     E     F           A = (1, 0); the section is mapped in four blocks
//      `C    D  0.7
//        A---B  0       quarter = 1: a quarter turn of it in space, about y
DefineConstant[ nr = 10, na = 8, quarter = 0, nt = 6 ];
SetFactory("OpenCASCADE");
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

c = Cos(Pi / 4);
Point(1) = {0, 0, 0};
Point(2) = {1, 0, 0};                               // A
Point(3) = {1.4, 0, 0};                             // B
Point(4) = {Cos(Pi / 8), Sin(Pi / 8), 0};           // C
Point(5) = {1.4 * Cos(Pi / 6), 1.4 * Sin(Pi / 6), 0}; // D
Point(6) = {c, c, 0};                               // E
Point(7) = {(1 + 1.4 * Cos(Pi / 6)) / 2, (1.39 + 0.7) / 2, 0}; // F
Point(8) = {c, (c + 1.79) / 2, 0};                  // M
Point(9) = {1, 1.39, 0};                            // G
Point(10) = {c, 1.79, 0};                           // H
Point(11) = {1, 1.79, 0};                           // I
For i In {1:5}
  Line(i) = {2 * i, 2 * i + 1};                     // across
EndFor
Circle(11) = {2, 1, 4};
Circle(12) = {4, 1, 6};
Line(13) = {6, 8};
Line(14) = {8, 10};
Circle(21) = {3, 1, 5};
Line(22) = {5, 7};
Line(23) = {7, 9};
Line(24) = {9, 11};
For i In {1:4}
  Curve Loop(i) = {i, 20 + i, -(i + 1), -(10 + i)};
  Plane Surface(i) = {i};
  Transfinite Surface{i} = {2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2};
  Transfinite Curve{10 + i, 20 + i} = na + 1;
EndFor
Transfinite Curve{11, 21} = na + 1 Using Progression 1.2; // the stress is asked for at A
Transfinite Curve{1:5} = nr + 1 Using Progression 1.2;
Recombine Surface{:};

If (quarter == 0)
  Physical Surface("BODY") = {1:4};
  Physical Curve("BOTTOM") = {1};
  Physical Curve("TOP") = {5};
Else
  Extrude{{0, 1, 0}, {0, 0, 0}, Pi / 2}{ Surface{1:4}; Layers{nt}; Recombine; }
  Physical Volume("BODY") = {1:4};
EndIf
